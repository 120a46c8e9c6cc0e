#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/quantities/quantity.hpp"

namespace cli {

/// Quantity and range of an axis.
struct Axis {
  std::string name;
  std::string unit = {};  ///< SI or deg; "" for none
  bool logarithmic = false;
};

/// A quantity of the tables, in its printed unit: "peak pressure" in "Pa".
Axis axis_of(std::string_view symbol, std::string_view meaning,
             contact::Dimension dimension);
template <class T>
Axis axis_of(const contact::Quantity<T>& q) {
  return axis_of(
      q.stem(),
      q.is_vector() && !q.length_meaning.empty() ? q.length_meaning : q.meaning,
      q.dimension);
}
/// Short, for panels: its symbol alone.
template <class T>
Axis short_axis_of(const contact::Quantity<T>& q) {
  return axis_of(q.stem(), "", q.dimension);
}

/// A symbol of the tables as it is printed in pictures: "θ₀" of "theta0",
/// "Mₜ" of "M_t".
std::string shown_symbol(std::string_view symbol);
/// A unit's symbol with µ: "µm" of "um".
std::string with_micro(std::string unit);

/// A unit's prefix, and the factor of the numbers for it.
struct Prefix {
  std::string_view name = "";
  double factor = 1;
};

/// The smallest and the largest of the values that an axis has a place for.
struct Extent {
  double low;
  double high;
  bool is_empty() const { return !(low <= high); }
};
Extent extent_of(std::span<const double> values, bool logarithmic);
Extent joined(const Extent& a, const Extent& b);

/// The one with which numbers of an axis are short: of a linear one up to 10^4
/// and not below 10^-2, of a logarithmic one in its middle. None for units that
/// take none (deg, s, m²).
Prefix prefix_of(const Axis& axis, const Extent& extent);

/// "peak pressure, MPa"
std::string label_of(const Axis& axis, const Prefix& prefix);

/// Numbers at places of an axis, as many as there is room for.
struct Ticks {
  Extent range = {0, 1};  ///< from end to end of the axis
  std::vector<double> places = {};
  std::vector<std::string> labels = {};

  /// Position of a number: 0 at the low end, 1 at the high one; 0.5 for NaN.
  double share(double number, bool logarithmic) const;
  /// Width of the widest label.
  double width() const;
  /// gnuplot's range and labels of "x" or "y"; without labels marks alone.
  std::string script(std::string_view axis, bool labels_too = true) const;
};

/// gnuplot's marks, with which numbers stand where the next two have them.
inline constexpr std::string_view tick_style =
    "set tics scale 0.5\nset xtics offset 0,0.35\n";
/// From y to the ends of its numbers, em.
inline constexpr double beside_axis = 1.4;
/// From x to the end of its label, em.
inline constexpr double under_axis = 2.9;

enum class Run { across, up };

/// @param room    length of the axis, em
/// @param whole   the axis ends with ticks, not with the data; of linear ones
Ticks ticks_of(const Axis& axis, const Extent& extent, Run run, double room,
               bool whole);

}  // namespace cli
