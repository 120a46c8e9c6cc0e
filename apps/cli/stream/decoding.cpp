#include "cli/stream/decoding.hpp"

#include <array>
#include <cerrno>
#include <utility>

#include "libcontact/base/error.hpp"

namespace cli {
namespace {

// Byte order marks, and their encodings.
constexpr std::pair<std::string_view, const char*> marks[] = {
    {"\xEF\xBB\xBF", nullptr},
    {"\xFF\xFE", "UTF-16LE"},
    {"\xFE\xFF", "UTF-16BE"}};
constexpr std::string_view replacement = "\xEF\xBF\xBD";  // for invalid bytes

void* made_converter(const char* from) {
  const iconv_t made = iconv_open("UTF-8", from);
  if (made != iconv_t(-1)) return made;
  throw contact::Error(std::string("this system cannot convert ") + from);
}

}  // namespace

void TextDecoder::find_encoding() {
  bool may_come = false;
  for (const auto& [mark, name] : marks) {
    may_come = may_come || mark.starts_with(start_);
    if (!start_.starts_with(mark)) continue;
    start_.erase(0, mark.size());
    if (name) converter_.reset(made_converter(name));
    is_known_ = true;
    return;
  }
  is_known_ = !may_come;
}

void TextDecoder::decode(std::string_view bytes, std::string& to) {
  if (is_known_) return decode_known(bytes, to);
  start_ += bytes;
  find_encoding();
  if (!is_known_) return;
  decode_known(start_, to);
  start_.clear();
}

void TextDecoder::finish(std::string& to) {
  add_lines(start_, to);
  start_.clear();
  if (!rest_.empty()) to += replacement;
  if (return_) to += '\n';
  rest_.clear();
  return_ = false;
}

void TextDecoder::decode_known(std::string_view bytes, std::string& to) {
  if (!converter_) return add_lines(bytes, to);
  std::string text;
  decode_utf16(bytes, text);
  add_lines(text, to);
}

void TextDecoder::decode_utf16(std::string_view bytes, std::string& to) {
  rest_ += bytes;
  char* from = rest_.data();
  std::size_t left = rest_.size();
  std::array<char, 4096> made;
  while (left > 0) {
    char* end = made.data();
    std::size_t room = made.size();
    const bool is_done = iconv(converter_.get(), &from, &left, &end, &room) !=
                         static_cast<std::size_t>(-1);
    const int why = is_done ? 0 : errno;
    to.append(made.data(), end);
    if (why == EINVAL) break;  // incomplete character: wait for more
    if (why != EILSEQ) continue;
    to += replacement;
    from += 2;
    left -= 2;
  }
  rest_.erase(0, rest_.size() - left);
}

void TextDecoder::add_lines(std::string_view text, std::string& to) {
  if (text.empty()) return;
  if (return_) to += text.front() == '\n' ? '\r' : '\n';
  return_ = text.back() == '\r';
  if (return_) text.remove_suffix(1);
  for (;;) {
    const std::size_t at = text.find('\r');
    to += text.substr(0, at);
    if (at == text.npos) return;
    text.remove_prefix(at + 1);
    to += text.starts_with('\n') ? '\r' : '\n';
  }
}

}  // namespace cli
