#pragma once

#include <string>
#include <string_view>

#include "libcontact/base/dimension.hpp"

namespace cli {

/// Unit in which the numbers of a column are shown to people.
struct ShownUnit {
  std::string stem;         ///< the column's name without its unit
  std::string symbol = {};  ///< "MPa", "um", "°"; "" for none
  double divide = 1;        ///< from the column's number to the shown one
  bool prefixes = false;    ///< true if SI prefixes are allowed

  /// The unit with the prefix that leaves 1 to 1000 of `value` (1.234e7 Pa in
  /// MPa), or the unit itself if it takes no prefix.
  ShownUnit scaled(double value) const;
  /// Four significant digits; a number given with fewer digits stays as it is.
  std::string text(double value) const;
};

/// The unit at the end of a column's name: Pa, with prefixes, for "p_peak_Pa".
ShownUnit shown_unit(std::string_view column);

}  // namespace cli
