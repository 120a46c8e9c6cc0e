#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "support/error_message.hpp"

namespace contact::test {

using Texts = std::vector<std::string>;

/// A CSV text as programs write it: rows of cells, the first one the header;
/// quotes stay.
std::vector<Texts> csv_rows(std::string_view text);

/// One column of csv_rows() below its header; throws contact::Error if there
/// is none of that name.
Texts csv_column(const std::vector<Texts>& rows, std::string_view name);

/// csv_rows() by column. Rows count from 1; the first row is the default. A
/// cell without a number is NaN.
class CsvTable {
 public:
  explicit CsvTable(std::string_view csv) : rows_(csv_rows(csv)) {}

  std::size_t size() const { return rows_.size() - 1; }
  const std::vector<std::string>& names() const { return rows_.front(); }
  /// A column as text, and as numbers.
  Texts texts(std::string_view column) const {
    return csv_column(rows_, column);
  }
  const std::vector<double>& operator[](const std::string& column) const;

  std::string text(std::size_t row, const std::string& column) const {
    return texts(column).at(row - 1);
  }
  std::string text(const std::string& column) const { return text(1, column); }
  double at(std::size_t row, const std::string& column) const {
    return (*this)[column].at(row - 1);
  }
  double at(const std::string& column) const { return at(1, column); }

  /// Row of a quantity, in tables that have one in each row.
  std::size_t row_of(const std::string& quantity) const;
  double value(const std::string& quantity) const {
    return at(row_of(quantity), "value");
  }

 private:
  std::vector<Texts> rows_;
  mutable std::map<std::string, std::vector<double>> numbers_;
};

/// Exit and output of a program.
struct ProgramResult {
  int status;  ///< exit status, or -1 for a signal
  std::string out;
  std::string err;
};

/// An empty folder with the project's data folder as "data", in which programs
/// of the project are run by name; removed at the end.
class ProgramFolder {
 public:
  ProgramFolder();
  ~ProgramFolder();
  ProgramFolder(const ProgramFolder&) = delete;
  ProgramFolder& operator=(const ProgramFolder&) = delete;

  /// Runs a shell command with the folder as working directory and the built
  /// programs first on PATH.
  ProgramResult run(const std::string& command) const;
  /// As above; the exit status must be 0.
  ProgramResult run_well(const std::string& command) const;
  /// As above; the program must end with this status and message.
  void run_ill(const std::string& command, int status,
               const std::string& said) const;
  /// Standard output of run_well().
  CsvTable table(const std::string& command) const {
    return CsvTable(run_well(command).out);
  }

  const std::filesystem::path& path() const { return path_; }
  void write(const std::string& name, std::string_view text) const;
  std::string read(const std::string& name) const;
  bool has(const std::string& name) const;
  bool has_gnuplot() const { return run("command -v gnuplot").status == 0; }
  /// three.js and dygraphs, required for pages of replays.
  bool has_page_libraries() const;
  /// Names of the existing files, including hidden ones, without "data".
  Texts files() const;

 private:
  std::filesystem::path path_;
  std::filesystem::path streams_;
};

/// The commands under "Examples:" in the --help of a program.
Texts help_examples(const std::string& program);

inline std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

}  // namespace contact::test
