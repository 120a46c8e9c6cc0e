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

/// A quantity of the tables in its printed unit: "peak pressure" in "Pa".
Axis axis_of(std::string_view symbol, std::string_view meaning,
             contact::Dimension dimension);
template <class T>
Axis axis_of(const contact::Quantity<T>& q) {
  return axis_of(
      q.stem(),
      q.is_vector() && !q.length_meaning.empty() ? q.length_meaning : q.meaning,
      q.dimension);
}
/// Short axis for panels: the symbol alone.
template <class T>
Axis short_axis_of(const contact::Quantity<T>& q) {
  return axis_of(q.stem(), "", q.dimension);
}

/// A symbol of the tables as pictures print it: "θ₀" for "theta0", "Mₜ" for
/// "M_t".
std::string shown_symbol(std::string_view symbol);
/// A unit's symbol with µ: "µm" for "um".
std::string with_micro(std::string unit);

/// A unit's prefix and the factor that it stands for.
struct Prefix {
  std::string_view name = "";
  double factor = 1;
};

/// The smallest and the largest value that an axis can show.
struct Extent {
  double low;
  double high;
  bool is_empty() const { return !(low <= high); }
};
Extent extent_of(std::span<const double> values, bool logarithmic);
Extent joined(const Extent& a, const Extent& b);

/// The prefix that gives short labels: on a linear axis numbers from 10^-2 to
/// 10^4, on a logarithmic one in its middle. None for units without prefixes
/// (deg, s, m²).
Prefix prefix_of(const Axis& axis, const Extent& extent);

/// "peak pressure, MPa"
std::string label_of(const Axis& axis, const Prefix& prefix);

/// Numbered ticks of an axis, as many as fit.
struct Ticks {
  Extent range = {0, 1};  ///< from end to end of the axis
  std::vector<double> places = {};
  std::vector<std::string> labels = {};

  /// Position of a number: 0 at the low end, 1 at the high end; 0.5 for NaN.
  double share(double number, bool logarithmic) const;
  /// Width of the widest label.
  double width() const;
  /// gnuplot's range and labels for "x" or "y"; without labels only marks.
  std::string script(std::string_view axis, bool labels_too = true) const;
};

/// gnuplot's style of ticks, which the next two distances assume.
inline constexpr std::string_view tick_style =
    "set tics scale 0.5\nset xtics offset 0,0.35\n";
/// Distance of the y axis from the ends of its numbers, em.
inline constexpr double beside_axis = 1.4;
/// Distance of the x axis from the lower end of its label, em.
inline constexpr double under_axis = 3.3;

enum class Run { across, up };

/// @param room   length of the axis, em
/// @param whole  the axis ends at ticks, not at the data; linear axes only
Ticks ticks_of(const Axis& axis, const Extent& extent, Run run, double room,
               bool whole);

}  // namespace cli
