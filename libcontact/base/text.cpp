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

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

// A byte inside a UTF-8 sequence.
bool is_continuation(char c) {
  return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}

// Bytes of the character that `text` begins with; 0 if that is a control
// character or the bytes are not UTF-8.
std::size_t shown_bytes(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  if (lead < 0x80) return is_control(text.front()) ? 0 : 1;
  if (lead < 0xc2 || lead > 0xf4) return 0;
  const std::size_t size = lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
  // The first character that takes so many; of two, the first beyond the
  // control characters.
  constexpr std::array<char32_t, 3> first = {0xa0, 0x800, 0x10000};
  if (text.size() < size) return 0;
  char32_t character = lead & (0x7f >> size);
  for (const char c : text.substr(1, size - 1)) {
    if (!is_continuation(c)) return 0;
    character = character << 6 | (static_cast<unsigned char>(c) & 0x3f);
  }
  const bool surrogate = character >= 0xd800 && character < 0xe000;
  return character < first[size - 2] || character > 0x10ffff || surrogate
             ? 0
             : size;
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

bool has_control_characters(std::string_view text) {
  return std::ranges::any_of(text, is_control);
}

std::string printable(std::string_view text, std::size_t longest) {
  std::string shown;
  while (!text.empty()) {
    if (shown.size() >= longest) return shown + "...";
    const std::size_t bytes = shown_bytes(text);
    if (bytes == 0) {
      shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
    } else {
      shown += text.substr(0, bytes);
    }
    text.remove_prefix(std::max<std::size_t>(bytes, 1));
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
