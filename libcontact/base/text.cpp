#include "libcontact/base/text.hpp"

#include <fmt/args.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace contact::detail {
namespace {

constexpr std::size_t longest_compared = 63;

// A byte inside a UTF-8 sequence.
bool is_continuation(char c) {
  return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}

// A character and the bytes that it takes; 0 bytes if they are not UTF-8.
struct Character {
  char32_t code;
  std::size_t bytes;
};

// The one that `text` begins with.
Character first_character(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  if (lead < 0x80) return {lead, 1};
  if (lead < 0xc2 || lead > 0xf4) return {};
  const std::size_t size = lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
  // The first character that takes so many.
  constexpr std::array<char32_t, 3> first = {0x80, 0x800, 0x10000};
  if (text.size() < size) return {};
  char32_t code = lead & (0x7f >> size);
  for (const char c : text.substr(1, size - 1)) {
    if (!is_continuation(c)) return {};
    code = code << 6 | (static_cast<unsigned char>(c) & 0x3f);
  }
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  if (code < first[size - 2] || code > 0x10ffff || surrogate) return {};
  return {code, size};
}

// Characters that could end a line, control a terminal, or reverse the text
// beside them, so that a name reads as another one.
bool is_control(char32_t c) {
  const bool control = c < 0x20 || (c >= 0x7f && c < 0xa0);
  const bool separator_or_embedding = c >= 0x2028 && c <= 0x202e;
  const bool direction =
      c == 0x61c || c == 0x200e || c == 0x200f || (c >= 0x2066 && c <= 0x2069);
  return control || separator_or_embedding || direction;
}

// Slips between two words (optimal string alignment distance).
std::size_t slips(std::string_view a, std::string_view b) {
  using Row = std::array<std::size_t, longest_compared + 1>;
  Row before_last{};
  Row last{};
  Row row{};
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last = last;
    last = row;
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = last[j - 1] + (a[i - 1] != b[j - 1]);
      row[j] = std::min({changed, last[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before_last[j - 2] + 1);
      }
    }
  }
  return row[b.size()];
}

}  // namespace

std::string filled(std::string_view form,
                   std::initializer_list<MessagePart> parts) {
  fmt::dynamic_format_arg_store<fmt::format_context> values;
  for (const MessagePart& part : parts) {
    std::visit([&](const auto& value) { values.push_back(value); },
               part.value_);
  }
  return fmt::vformat(form, values);
}

std::string joined(std::span<const std::string> words,
                   std::string_view separator) {
  return fmt::format("{}", fmt::join(words, separator));
}

std::string_view trimmed(std::string_view text, std::string_view of) {
  text.remove_prefix(std::min(text.find_first_not_of(of), text.size()));
  return text.substr(0, text.find_last_not_of(of) + 1);
}

bool has_control_characters(std::string_view text) {
  while (!text.empty()) {
    const auto [code, bytes] = first_character(text);
    if (bytes > 0 && is_control(code)) return true;
    text.remove_prefix(std::max<std::size_t>(bytes, 1));
  }
  return false;
}

std::string printable(std::string_view text, std::size_t longest) {
  std::string shown;
  while (!text.empty()) {
    if (shown.size() >= longest) return shown + "...";
    const auto [code, size] = first_character(text);
    const std::string_view bytes =
        text.substr(0, std::max<std::size_t>(size, 1));
    if (size > 0 && !is_control(code)) {
      shown += bytes;
    } else {
      for (const char byte : bytes) {
        shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
      }
    }
    text.remove_prefix(bytes.size());
  }
  return shown;
}

std::string nearest(std::string_view word,
                    std::span<const std::string> candidates) {
  if (word.size() > longest_compared) return {};
  std::string best;
  std::size_t fewest = std::min<std::size_t>(3, (word.size() + 1) / 2);
  for (const std::string& candidate : candidates) {
    if (candidate.size() > longest_compared) continue;
    const std::size_t count = slips(word, candidate);
    if (count >= fewest) continue;
    fewest = count;
    best = candidate;
  }
  return best;
}

}  // namespace contact::detail
