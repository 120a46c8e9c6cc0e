#include "cli/number.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "libcontact/base/number.hpp"

namespace cli {
namespace {

constexpr std::string_view blanks = " \t";

}  // namespace

std::string Allowed::text() const {
  const std::string interval = number_text(min) + " to " + number_text(max);
  return unit.empty() ? interval : interval + ' ' + std::string(unit);
}

std::optional<double> take_number(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  // from_chars accepts no plus sign; "+-1" stays wrong.
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') {
    text.remove_prefix(1);
  }
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] =
      contact::detail::number_from(text.data(), end, value);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  return value;
}

std::optional<double> parse_number(std::string_view text) {
  const auto value = take_number(text);
  if (text.find_first_not_of(blanks) != text.npos) return std::nullopt;
  return value;
}

char* write_number(char* to, double value) {
  return std::to_chars(to, to + longest_number, value).ptr;
}

std::string number_text(double value) {
  char buffer[longest_number];
  return {buffer, write_number(buffer, value)};
}

std::string rounded_text(double value, int digits) {
  if (std::isnan(value)) return "-";
  std::array<char, 64> buffer;
  // The flag '#' of printf keeps trailing zeros, but also a final point.
  const int length =
      std::snprintf(buffer.data(), buffer.size(), "%#.*g", digits, value);
  std::string text(buffer.data(), static_cast<std::size_t>(length));
  if (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace cli
