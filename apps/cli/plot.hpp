#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/picture/axis.hpp"

namespace cli {

/// Largest number of curves in a legend.
inline constexpr std::size_t most_curves = 15;
/// Throws contact::Error if there are more.
void check_curves(std::size_t curves);

/// One line of a line plot.
struct Curve {
  std::string label;  ///< "" for none
  std::vector<double> x;
  std::vector<double> y;  ///< NaN leaves a gap
  bool dashed = false;
  int colour = 0;  ///< curves of one number > 0 share a colour
};

/// Whether their numbers, all above 0, are so far apart that a linear axis
/// would hide the small ones.
bool is_wide(const std::vector<Curve>& curves);

/// A second, lower panel over the same x: errors of the upper panel.
struct LowerPanel {
  Axis y;
  double half_range = 1;  ///< y from -half_range to half_range
  std::vector<Curve> curves;
};

/// A line plot with a legend beside or, where labels are long, below it.
struct LinePlot {
  std::string title;
  Axis x;
  Axis y;
  /// The curves are one family in order, coloured from dark to light.
  bool family = false;
  std::vector<Curve> curves;
  std::optional<LowerPanel> lower = {};
};

/// Draws a line plot with gnuplot, in the style of plots/style.gp. Units take
/// prefixes that leave the axes short numbers. Labels stand at the ends of
/// their curves where there is room; curves that lie on others are dashed over
/// them.
/// @param file  name of the picture; appears when it is complete
/// @return as for draw_script()
std::string draw(const LinePlot& plot, const std::string& file);

/// A curve with an axis of its own, from 0 up.
struct Panel {
  Axis axis;
  std::vector<double> y;                 ///< not below 0; NaN leaves a gap
  std::optional<std::size_t> mark = {};  ///< a point to be shown, with its y
};

/// Panels one above the other over the same x.
struct PanelPlot {
  std::string title;
  Axis x;
  std::vector<double> values;  ///< values on the x axis
  std::vector<Panel> panels;
};

/// As above. Of points too many to be told apart the extremes are drawn.
std::string draw(const PanelPlot& plot, const std::string& file);

}  // namespace cli
