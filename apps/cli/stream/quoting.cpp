#include "cli/stream/quoting.hpp"

#include <algorithm>

#include "libcontact/base/text.hpp"

namespace cli {
namespace {

bool is_alphanumeric(char c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') ||
         (c >= 'a' && c <= 'z');
}

bool is_among(char c, std::string_view characters) {
  return characters.find(c) != characters.npos;
}

// True if Markdown would interpret the character at this place. Within names of
// keys, load_N and layer[1], it does not interpret "_" and brackets.
bool is_markup(std::string_view text, std::size_t at) {
  const char before = at > 0 ? text[at - 1] : ' ';
  const char after = at + 1 < text.size() ? text[at + 1] : ' ';
  switch (text[at]) {
    case '_':
      return !is_alphanumeric(before) || !is_alphanumeric(after);
    case ']':
      return is_among(after, "([");
    case '&':
      return after == '#' || is_alphanumeric(after);
    default:
      return is_among(text[at], "|\\`*<~$");
  }
}

std::string printable(std::string_view text) {
  return contact::detail::printable(text, text.npos);
}

}  // namespace

std::string markdown_text(std::string_view text) {
  const std::string shown = printable(text);
  std::string result;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (is_markup(shown, i)) result += '\\';
    result += shown[i];
  }
  return result;
}

std::string latex_text(std::string_view text) {
  const std::string shown = printable(text);
  std::string result;
  if (!shown.empty() && is_among(shown[0], "[*")) result = "{}";
  for (const char c : shown) {
    switch (c) {
      case '\\':
        result += "\\textbackslash{}";
        break;
      case '~':
        result += "\\textasciitilde{}";
        break;
      case '^':
        result += "\\textasciicircum{}";
        break;
      default:
        if (is_among(c, "#$%&_{}")) result += '\\';
        result += c;
    }
  }
  return result;
}

std::string shell_word(std::string_view text) {
  const auto is_plain = [](char c) {
    return is_alphanumeric(c) || is_among(c, "%+,-./:=@_");
  };
  if (!text.empty() && std::ranges::all_of(text, is_plain)) {
    return std::string(text);
  }
  std::string word = "'";
  for (const char c : text) {
    word += c == '\'' ? "'\\''" : std::string(1, c);
  }
  return word + '\'';
}

std::string terminal_text(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\n\t"), text.size());
    shown += printable(text.substr(0, end));
    if (end < text.size()) shown += text[end];
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return shown;
}

std::size_t terminal_width(std::string_view text) {
  // Skips continuation bytes.
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) >> 6) != 2; }));
}

}  // namespace cli
