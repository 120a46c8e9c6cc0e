#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "libcontact/base/dimension.hpp"

/// Units in the names of keys: radius_mm.
namespace contact::detail {

/// The key alone, but for temperatures, then with every ending.
std::vector<std::string> spellings(std::string_view key, Dimension dimension);
/// "radius (in m), radius_m or radius_mm"
std::string spellings_text(std::string_view key, Dimension dimension);
/// The unit that one of the spellings has; null for any other text.
const Unit* unit_in(std::string_view spelling, std::string_view key,
                    Dimension dimension);

/// Rule for a number: "above 0 and below 50 mm"; 0 alone needs no unit.
std::string range_text(const Interval& range, const Unit& unit);

}  // namespace contact::detail
