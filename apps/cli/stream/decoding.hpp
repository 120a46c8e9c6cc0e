#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cli {

/// Text of a file as UTF-8 whose lines end with "\n" or "\r\n", piece by piece:
/// a byte order mark is taken off, UTF-16 that has one (as spreadsheets save
/// "Unicode text") becomes UTF-8, and "\r" alone ends a line. Other bytes stay.
class TextDecoder {
 public:
  /// Appends what these bytes say, which follow those of before.
  void decode(std::string_view bytes, std::string& to);
  /// Appends what was kept back for bytes that do not come.
  void finish(std::string& to);

 private:
  enum class Encoding { unknown, bytes, little, big };

  void find_encoding();
  void decode_known(std::string_view bytes, std::string& to);
  void decode_utf16(std::string_view bytes, std::string& to);
  void add_unit(std::uint32_t unit, std::string& to);
  void add_lines(std::string_view text, std::string& to);

  Encoding encoding_ = Encoding::unknown;
  std::string start_ = {};  ///< until the encoding is known
  std::optional<unsigned char> half_ = {};
  std::uint32_t high_ = 0;  ///< first of a pair of surrogates
  bool return_ = false;     ///< "\r" was last
};

}  // namespace cli
