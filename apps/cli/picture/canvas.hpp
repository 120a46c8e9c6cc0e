#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cli {

/// A part of a picture; em from its left and its top.
struct Box {
  double left;
  double right;
  double top;
  double bottom;
  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

/// Entry of a legend for one curve.
struct LegendEntry {
  std::string label;
  std::string line = {};   ///< gnuplot's style of it; "" for none
  std::string point = {};  ///< the same
};

enum class Anchor { left, center, right };

/// Layout of a picture's texts: each is placed by its measured size, so that
/// none leaves the canvas or lies over another one.
class Canvas {
 public:
  /// Takes the room of the title, in as many lines as it needs, and of the
  /// legend: to the right of the plots, or, where it is wide, below them on a
  /// canvas that is higher.
  explicit Canvas(std::string_view title,
                  const std::vector<LegendEntry>& legend = {});

  /// Room that is still free.
  const Box& room() const { return room_; }
  /// Height over the height of a canvas without a legend below the plots.
  double stretch() const { return stretch_; }
  /// The title and the legend. One beside the plots has its entries, from the
  /// top of the canvas, at the heights of their curves' ends as far as there is
  /// room; in the middle without heights.
  std::string script(std::vector<double> heights = {}) const;

  /// A text, its anchor and the middle of its height at a place.
  std::string text(double x, double y, std::string_view text,
                   Anchor anchor = Anchor::center) const;
  /// Upwards, in as many lines as it needs, the last with its middle at x.
  std::string upward(double x, const Box& beside, std::string_view text) const;
  /// How much room upward() takes beside its last line's middle.
  static double upward_width(double room, std::string_view text);
  /// Above a plot, in as many lines as it needs.
  std::string above(const Box& plot, std::string_view text) const;
  static double above_height(const Box& plot, std::string_view text);
  /// gnuplot's margins of a plot.
  std::string margins(const Box& plot) const;
  /// Place of gnuplot's colours.
  std::string colour_box(const Box& box) const;
  /// "X,Y" of gnuplot's screen.
  std::string at(double x, double y) const;

 private:
  std::string entry(double x, double y, const LegendEntry& of) const;

  Box room_;
  double stretch_ = 1;
  std::string script_;
  std::vector<LegendEntry> beside_;  // at the right of the room
};

}  // namespace cli
