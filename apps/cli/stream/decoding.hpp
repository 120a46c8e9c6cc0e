#pragma once

#include <iconv.h>

#include <memory>
#include <string>
#include <string_view>

namespace cli {

/// Decodes a file piece by piece into UTF-8 lines that end with "\n" or "\r\n".
/// It removes a byte order mark, converts UTF-16 with a mark (which
/// spreadsheets save as "Unicode text"), and ends a line at "\r" alone. Other
/// bytes stay.
class TextDecoder {
 public:
  /// Appends the text of the next bytes.
  /// @throws contact::Error for UTF-16 if the system cannot convert it
  void decode(std::string_view bytes, std::string& to);
  /// Appends incomplete characters at the end of the input.
  void finish(std::string& to);

 private:
  struct Close {
    void operator()(void* converter) const { iconv_close(converter); }
  };

  void find_encoding();
  void decode_known(std::string_view bytes, std::string& to);
  void decode_utf16(std::string_view bytes, std::string& to);
  void add_lines(std::string_view text, std::string& to);

  bool is_known_ = false;   ///< the encoding
  std::string start_ = {};  ///< until the encoding is known
  std::unique_ptr<void, Close> converter_ = {};  ///< from UTF-16
  std::string rest_ = {};                        ///< part of a character
  bool return_ = false;                          ///< "\r" was last
};

}  // namespace cli
