#pragma once

#include <iconv.h>

#include <memory>
#include <string>
#include <string_view>

namespace cli {

/// Text of a file as UTF-8 whose lines end with "\n" or "\r\n", piece by piece:
/// a byte order mark is taken off, UTF-16 that has one (as spreadsheets save
/// "Unicode text") becomes UTF-8, and "\r" alone ends a line. Other bytes stay.
class TextDecoder {
 public:
  /// Appends the text of these bytes, which follow the last ones.
  /// @throws contact::Error of UTF-16 where the system cannot convert it
  void decode(std::string_view bytes, std::string& to);
  /// Appends what was kept back for bytes that do not come.
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
