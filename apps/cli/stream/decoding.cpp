#include "cli/stream/decoding.hpp"

namespace cli {
namespace {

constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";
constexpr std::string_view little_mark = "\xFF\xFE";
constexpr std::string_view big_mark = "\xFE\xFF";
constexpr std::uint32_t replacement = 0xFFFD;  // for what is no character

void append_utf8(std::uint32_t character, std::string& to) {
  const auto low = [character](int shift) {
    return static_cast<char>(0x80 | ((character >> shift) & 0x3F));
  };
  if (character < 0x80) {
    to += static_cast<char>(character);
  } else if (character < 0x800) {
    to += {static_cast<char>(0xC0 | (character >> 6)), low(0)};
  } else if (character < 0x10000) {
    to += {static_cast<char>(0xE0 | (character >> 12)), low(6), low(0)};
  } else {
    to +=
        {static_cast<char>(0xF0 | (character >> 18)), low(12), low(6), low(0)};
  }
}

}  // namespace

void TextDecoder::find_encoding() {
  const auto take = [this](std::string_view mark, Encoding encoding) {
    if (!start_.starts_with(mark)) return false;
    start_.erase(0, mark.size());
    encoding_ = encoding;
    return true;
  };
  if (take(little_mark, Encoding::little) || take(big_mark, Encoding::big) ||
      take(utf8_mark, Encoding::bytes)) {
    return;
  }
  const bool may_come = little_mark.starts_with(start_) ||
                        big_mark.starts_with(start_) ||
                        utf8_mark.starts_with(start_);
  if (!may_come) encoding_ = Encoding::bytes;
}

void TextDecoder::decode(std::string_view bytes, std::string& to) {
  if (encoding_ != Encoding::unknown) return decode_known(bytes, to);
  start_ += bytes;
  find_encoding();
  if (encoding_ == Encoding::unknown) return;
  decode_known(start_, to);
  start_.clear();
}

void TextDecoder::finish(std::string& to) {
  add_lines(start_, to);
  start_.clear();
  if (half_ || high_ != 0) append_utf8(replacement, to);
  if (return_) to += '\n';
  half_.reset();
  high_ = 0;
  return_ = false;
}

void TextDecoder::decode_known(std::string_view bytes, std::string& to) {
  if (encoding_ == Encoding::bytes) return add_lines(bytes, to);
  std::string text;
  decode_utf16(bytes, text);
  add_lines(text, to);
}

void TextDecoder::decode_utf16(std::string_view bytes, std::string& to) {
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (!half_) {
      half_ = byte;
      continue;
    }
    const std::uint32_t first = *half_;
    half_.reset();
    add_unit(encoding_ == Encoding::big ? first << 8 | byte : byte << 8 | first,
             to);
  }
}

void TextDecoder::add_unit(std::uint32_t unit, std::string& to) {
  const bool is_high = unit >= 0xD800 && unit < 0xDC00;
  const bool is_low = unit >= 0xDC00 && unit < 0xE000;
  if (high_ != 0 && is_low) {
    append_utf8(0x10000 + ((high_ - 0xD800) << 10) + (unit - 0xDC00), to);
    high_ = 0;
    return;
  }
  if (high_ != 0) append_utf8(replacement, to);
  high_ = is_high ? unit : 0;
  if (!is_high) append_utf8(is_low ? replacement : unit, to);
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
