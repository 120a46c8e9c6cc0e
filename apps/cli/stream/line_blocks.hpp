#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "cli/stream/decoding.hpp"

namespace cli {

/// Largest number of characters in a line. Longer lines are mistakes, such as a
/// file without line ends.
inline constexpr std::size_t longest_line = 1'000'000;

/// Some whole lines of a text.
struct LineBlock {
  /// Text of the lines. A line longer than longest_line may be truncated, but
  /// stays longer than that.
  std::string text;
  /// Number of the first line, from 1.
  std::size_t first_line = 1;
};

/// Removes the first line from `text` and returns it without "\n" or "\r\n".
std::string_view next_line(std::string_view& text);

/// Reads a file or standard input in blocks of whole lines, converted to UTF-8
/// (TextDecoder). Memory is one block for input of any length.
class LineReader {
 public:
  /// @param path  file name, "-" for standard input
  /// Throws contact::Error if it cannot be opened.
  explicit LineReader(const std::string& path);
  ~LineReader();
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;

  /// The next line alone (a header), no value at the end. Throws
  /// contact::Error if it is longer than longest_line.
  std::optional<std::string> line();
  /// The following lines read so far: at least one unless the input has ended.
  std::string_view ahead();
  /// Number of the next line, from 1.
  std::size_t next_number() const { return next_number_; }
  /// Reads the next lines; false at the end. Throws contact::Error if the input
  /// cannot be read.
  bool next(LineBlock& block);

  /// "points.csv" or "standard input", for messages.
  const std::string& name() const { return name_; }

 private:
  bool fill(std::string& text);
  void fetch_line();
  void skip_line();

  std::string name_;
  int descriptor_;
  bool at_end_ = false;
  std::string bytes_ = {};  ///< as they are in the file
  TextDecoder decoder_ = {};
  std::string rest_;  ///< read, but not returned yet
  std::size_t next_number_ = 1;
};

}  // namespace cli
