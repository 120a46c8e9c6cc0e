#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace cli {

/// Destination of a program's result: standard output, or a file that appears
/// under its name when it is complete and not at all otherwise. Until `commit`
/// the text is in a file with a temporary name in the same folder, which is
/// removed on errors, interrupts and termination. It is on the disk before it
/// gets its name, so that a power cut leaves it whole or not there.
///
/// On a terminal text is shown by terminal_text().
///
/// Something that is there and is not a regular file (/dev/null, a pipe) is
/// written directly.
class Output {
 public:
  /// @param path  file name; empty or "-" for standard output
  /// Throws contact::Error if the file cannot be made, is write-protected or a
  /// link to none, or has been read.
  explicit Output(const std::string& path);
  /// Checks without a trace that the file could be made, for a program to ask
  /// before its work. Throws contact::Error if not.
  static void check(const std::string& path);
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// Throws contact::Error if the text could not be written.
  void write(std::string_view text);
  /// The same of text whose parts of others are printable and that has escape
  /// sequences of its own.
  void write_coloured(std::string_view text) { write_all(text); }
  /// Gives the complete file its name. Throws contact::Error if it cannot, or
  /// if what has that name has been read since.
  void commit();

 private:
  /// Whether the descriptor is to be closed.
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
