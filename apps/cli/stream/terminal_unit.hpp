#pragma once

#include <string>
#include <string_view>

#include "libcontact/base/dimension.hpp"

namespace cli {

/// How the numbers of a column are shown to people.
struct ShownUnit {
  std::string stem;         ///< the column's name without its unit
  std::string symbol = {};  ///< "MPa", "um", "°"; "" for none
  double divide = 1;        ///< from the column's number to the shown one
  bool prefixes = false;    ///< whether SI prefixes may stand in front

  /// With the prefix that leaves 1 to 1000 of `value`: 1.234e7 Pa in MPa. The
  /// same if it takes none.
  ShownUnit scaled(double value) const;
  /// Four significant digits; a number that has fewer as it was given.
  std::string text(double value) const;
};

/// The unit that a column's name ends with: of "p_peak_Pa" Pa, with prefixes.
ShownUnit shown_unit(std::string_view column);

}  // namespace cli
