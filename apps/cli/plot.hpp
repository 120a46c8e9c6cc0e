#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/picture/axis.hpp"

namespace cli {

/// Largest number of curves in a legend.
inline constexpr std::size_t most_curves = 15;
/// Throws contact::Error for more curves.
void check_curves(std::size_t curves);

/// One line of a line plot.
struct Curve {
  std::string label;  ///< "" for none
  std::vector<double> x;
  std::vector<double> y;  ///< NaN leaves a gap
  bool dashed = false;
  int colour = 0;  ///< equal numbers > 0: the same colour
};

/// True if the numbers, all positive, are so far apart that a linear axis would
/// hide the small ones.
bool is_wide(const std::vector<Curve>& curves);

/// A second, lower panel over the same x: errors of the upper panel.
struct LowerPanel {
  Axis y;
  double half_range = 1;  ///< y from -half_range to half_range
  std::vector<Curve> curves;
};

/// A line plot with a legend beside it or, if labels are long, below it.
struct LinePlot {
  std::string title;
  Axis x;
  Axis y;
  /// The curves form an ordered family, coloured from dark to light.
  bool family = false;
  std::vector<Curve> curves;
  std::optional<LowerPanel> lower = {};
};

/// Draws a line plot with gnuplot in the style of plots/style.gp. Units take
/// prefixes that make the numbers on the axes short. Labels stand at the ends
/// of their curves if there is room; a curve that covers another one is dashed.
/// @param file  name of the picture; appears when it is complete
/// @return as for draw_script()
std::string draw(const LinePlot& plot, const std::string& file);

/// A curve with a y axis of its own that starts at 0.
struct Panel {
  Axis axis;
  std::vector<double> y;                 ///< not below 0; NaN leaves a gap
  std::optional<std::size_t> mark = {};  ///< a point to mark, with its y
};

/// Panels one above the other over the same x.
struct PanelPlot {
  std::string title;
  Axis x;
  std::vector<double> values;  ///< values on the x axis
  std::vector<Panel> panels;
};

/// As above. If there are too many points to distinguish, it draws the
/// extremes.
std::string draw(const PanelPlot& plot, const std::string& file);

}  // namespace cli
