#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "support/error_message.hpp"

namespace contact::test {

/// How a program ended and what it said.
struct ProgramResult {
  int status;  ///< exit status, or -1 for a signal
  std::string out;
  std::string err;
};

/// An empty folder with the project's data folder in it as "data", in which
/// programs of the project are run by name; removed at the end.
class ProgramFolder {
 public:
  ProgramFolder();
  ~ProgramFolder();
  ProgramFolder(const ProgramFolder&) = delete;
  ProgramFolder& operator=(const ProgramFolder&) = delete;

  /// Runs a shell command with the folder as working directory and the built
  /// programs first on PATH.
  ProgramResult run(const std::string& command) const;
  /// The same of one whose status has to be 0.
  ProgramResult run_well(const std::string& command) const;

  const std::filesystem::path& path() const { return path_; }
  void write(const std::string& name, std::string_view text) const;
  std::string read(const std::string& name) const;
  bool has(const std::string& name) const;
  /// Names of the files that are there, hidden ones too, without "data".
  std::vector<std::string> files() const;

 private:
  std::filesystem::path path_;
  std::filesystem::path streams_;
};

/// The commands under "Examples:" in the --help of a program.
std::vector<std::string> help_examples(const std::string& program);

/// A CSV text as programs write it: rows of cells, the first one the header;
/// quotes stay.
std::vector<std::vector<std::string>> csv_rows(std::string_view text);

/// One column of csv_rows() below its header; throws contact::Error if there
/// is none of that name.
std::vector<std::string> csv_column(
    const std::vector<std::vector<std::string>>& rows, std::string_view name);

}  // namespace contact::test
