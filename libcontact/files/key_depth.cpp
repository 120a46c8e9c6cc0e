#include "libcontact/files/key_depth.hpp"

#include <algorithm>
#include <string>

namespace contact::detail {
namespace {

// End of the string that begins at `begin`.
std::size_t end_of_string(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  const bool is_long = text.substr(begin).starts_with(std::string(3, quote));
  const std::string_view mark = text.substr(begin, is_long ? 3 : 1);
  for (std::size_t at = begin + mark.size(); at < text.size(); ++at) {
    if (text[at] == '\\' && quote == '"') {
      ++at;
    } else if (text[at] == '\n' && !is_long) {
      return at;
    } else if (text.substr(at).starts_with(mark)) {
      at += mark.size();
      if (!is_long) return at;
      // Up to two quotes before the mark belong to the string.
      const std::string_view rest = text.substr(at, 2);
      return at + std::min(rest.find_first_not_of(quote), rest.size());
    }
  }
  return text.size();
}

}  // namespace

std::size_t line_of_deep_key(std::string_view toml) {
  std::size_t parts = 1;
  for (std::size_t at = 0; at < toml.size();) {
    const char c = toml[at];
    if (c == '"' || c == '\'') {
      at = end_of_string(toml, at);
      continue;
    }
    if (c == '#') {
      at = std::min(toml.find('\n', at), toml.size());
      continue;
    }
    if (c == '.' && ++parts > most_key_parts) {
      const std::string_view before = toml.substr(0, at);
      return 1 + static_cast<std::size_t>(std::ranges::count(before, '\n'));
    }
    // Neither stands inside a key, but in its strings.
    if (std::string_view("\n=,[]{}").find(c) != std::string_view::npos) {
      parts = 1;
    }
    ++at;
  }
  return 0;
}

}  // namespace contact::detail
