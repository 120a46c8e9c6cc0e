#include "cli/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/refuse.hpp"

namespace cli {
namespace {

struct Unit {
  std::string_view suffix;
  double per_metre;  // exact, so that 50mm is the double nearest to 0.05
};
// Longer suffixes first: "mm" ends in "m".
constexpr std::array<Unit, 3> units = {{{"mm", 1e3}, {"um", 1e6}, {"m", 1}}};

}  // namespace

double parse_value(std::string_view option, std::string_view text,
                   const Allowed& allowed) {
  const auto value = parse_number(text);
  if (!value || !allowed.contains(*value)) {
    refuse(option, text, allowed.rule(value.has_value()));
  }
  return *value;
}

int parse_count(std::string_view option, std::string_view text, int min,
                int max) {
  const auto value = parse_number(text);
  if (!value || !(*value >= min && *value <= max) ||
      *value != std::floor(*value)) {
    refuse(option, text, fmt::format("a whole number, {} to {}", min, max));
  }
  return static_cast<int>(*value);
}

std::array<double, 3> parse_vector(std::string_view option,
                                   std::string_view text,
                                   std::string_view what) {
  std::array<double, 3> vector = {};
  std::string_view rest = text;
  bool good = std::count(text.begin(), text.end(), ',') == 2;
  for (std::size_t i = 0; good && i < 3; ++i) {
    const std::size_t comma = rest.find(',');
    const auto number = parse_number(rest.substr(0, comma));
    good = number && std::isfinite(*number);
    if (good) vector[i] = *number;
    rest.remove_prefix(comma == std::string_view::npos ? rest.size()
                                                       : comma + 1);
  }
  if (!good) refuse(option, text, fmt::format("X,Y,Z, {}", what));
  return vector;
}

double parse_length(std::string_view option, std::string_view text) {
  std::string_view digits = text;
  double per_metre = 1;
  for (const Unit& unit : units) {
    if (!text.ends_with(unit.suffix)) continue;
    digits.remove_suffix(unit.suffix.size());
    per_metre = unit.per_metre;
    break;
  }
  const auto number = parse_number(digits);
  if (!number || !std::isfinite(*number)) {
    refuse(option, text, "a length, in m or with one of the units mm, um");
  }
  if (*number <= 0) refuse(option, text, "above 0");
  return *number / per_metre;
}

}  // namespace cli
