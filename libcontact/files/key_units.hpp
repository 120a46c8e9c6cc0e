#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/files/dimension.hpp"

/// Units in the names of keys: radius_mm.
namespace contact::detail {

/// value in SI = value * multiply / divide; powers of ten are divided where
/// that is exact, so that 50 mm is the double nearest to 0.05 m.
struct KeyUnit {
  std::string_view ending;  ///< "" for none
  double multiply = 1;
  double divide = 1;

  double to_si(double value) const { return value * multiply / divide; }
  double from_si(double value) const { return value * divide / multiply; }
};

/// The first one is that of a key without an ending.
std::span<const KeyUnit> units_of(Dimension dimension);

/// The key alone, then with every ending.
std::vector<std::string> spellings(std::string_view key, Dimension dimension);
/// "radius (in m), radius_m or radius_mm"
std::string spellings_text(std::string_view key, Dimension dimension);
/// The unit that one of the spellings has; null for any other text.
const KeyUnit* unit_in(std::string_view spelling, std::string_view key,
                       Dimension dimension);

/// What a number must be: "above 0 and below 50 mm"; 0 alone needs no unit.
std::string range_text(const Interval& range, const KeyUnit& unit);

}  // namespace contact::detail
