#include "libcontact/files/key_units.hpp"

#include <algorithm>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/text.hpp"

namespace contact::detail {

namespace {

// 80 alone may be meant in either unit of a temperature.
bool needs_ending(Dimension dimension) {
  return dimension == Dimension::temperature;
}

}  // namespace

std::vector<std::string> spellings(std::string_view key, Dimension dimension) {
  std::vector<std::string> result;
  if (!needs_ending(dimension)) result.emplace_back(key);
  for (const Unit& unit : units_of(dimension)) {
    if (!unit.ending.empty())
      result.push_back(message("{}_{}", key, unit.ending));
  }
  return result;
}

std::string spellings_text(std::string_view key, Dimension dimension) {
  auto all = spellings(key, dimension);
  if (all.size() > 1 && !needs_ending(dimension)) {
    all[0] += message(" (in {})", unit_symbol(units_of(dimension)[0].ending));
  }
  return either(all);
}

const Unit* unit_in(std::string_view spelling, std::string_view key,
                    Dimension dimension) {
  if (!spelling.starts_with(key)) return nullptr;
  const std::string_view rest = spelling.substr(key.size());
  const auto all = units_of(dimension);
  if (rest.empty()) return needs_ending(dimension) ? nullptr : &all.front();
  if (rest.size() == 1 || rest.front() != '_') return nullptr;
  const auto unit = std::ranges::find(all, rest.substr(1), &Unit::ending);
  return unit == all.end() ? nullptr : &*unit;
}

std::string range_text(const Interval& range, const Unit& unit) {
  const bool any_low = range.low == -Interval::largest;
  const bool any_high = range.high == Interval::largest;
  const double low = unit.from_si(range.low);
  const double high = unit.from_si(range.high);
  const auto in_unit = [&](double value) {
    return unit.ending.empty() || (value == 0 && any_high)
               ? message("{:.6g}", value)
               : message("{:.6g} {}", value, unit_symbol(unit.ending));
  };
  std::string text;
  if (any_low && any_high) {
    text = "a finite number";
  } else if (any_high) {
    text =
        message(range.low_excluded ? "above {}" : "{} or above", in_unit(low));
  } else if (any_low) {
    text =
        message(range.high_excluded ? "below {}" : "up to {}", in_unit(high));
  } else if (!range.low_excluded && !range.high_excluded) {
    text = message("{:.6g} to {}", low, in_unit(high));
  } else {
    text = message("{} {:.6g} and {} {}", range.low_excluded ? "above" : "from",
                   low, range.high_excluded ? "below" : "up to", in_unit(high));
  }
  return range.or_infinity ? text + " or inf" : text;
}

}  // namespace contact::detail
