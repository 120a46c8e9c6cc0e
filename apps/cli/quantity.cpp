#include "cli/quantity.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "cli/number.hpp"
#include "libcontact/error.hpp"

namespace cli {
namespace {

struct Unit {
  std::string_view suffix;
  double per_metre;  // exact, so that 50mm is the double nearest to 0.05
};
// Longer suffixes first: "mm" ends in "m".
constexpr std::array<Unit, 3> units = {{{"mm", 1e3}, {"um", 1e6}, {"m", 1}}};

}  // namespace

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
  if (!number || !std::isfinite(*number) || *number <= 0) {
    throw contact::Error(
        fmt::format("{} {}: allowed a length above 0, in m or with one of "
                    "the units mm, um",
                    option, text));
  }
  return *number / per_metre;
}

}  // namespace cli
