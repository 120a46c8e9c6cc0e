#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace cli {

/// Destination of a program's result: standard output, or a file. Until
/// `commit` the text goes to a temporary file in the same folder, which is
/// removed on errors, interrupts and termination. The file is synced before it
/// is renamed, so after a power failure it is either complete or absent.
///
/// Text for a terminal passes through terminal_text().
///
/// An existing file that is not regular (/dev/null, a pipe) is written
/// directly.
class Output {
 public:
  /// @param path  file name; empty or "-" for standard output
  /// Throws contact::Error if the file cannot be made, is write-protected, is a
  /// dangling link, or has been read.
  explicit Output(const std::string& path);
  /// Checks that the file could be made, and leaves no trace. Programs call it
  /// before they start to work. Throws contact::Error if not.
  static void check(const std::string& path);
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// Throws contact::Error if the text could not be written.
  void write(std::string_view text);
  /// Writes printable text that contains escape sequences of the program
  /// itself.
  void write_coloured(std::string_view text) { write_all(text); }
  /// Gives the complete file its name. Throws contact::Error if that fails, or
  /// if a file with this name has been read meanwhile.
  void commit();

 private:
  /// True if the destructor closes the descriptor.
  bool is_own() const { return descriptor_ >= 0 && !path_.empty(); }
  void write_all(std::string_view text);
  void check_place(const std::filesystem::file_status& status) const;
  void discard();
  [[noreturn]] void fail(std::string_view what) const;

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  int descriptor_ = -1;
};

}  // namespace cli
