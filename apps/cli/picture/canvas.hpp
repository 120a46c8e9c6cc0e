#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

/// A rectangle of a picture, in em from the left and the top.
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
  std::string line = {};   ///< gnuplot's line style; "" for none
  std::string point = {};  ///< gnuplot's point style; "" for none
};

enum class Anchor { left, center, right };

/// Layout of a picture's texts. Each text is placed by its measured size, so
/// that it stays on the canvas and overlaps no other.
class Canvas {
 public:
  /// Reserves room for the title, in as many lines as needed, and for the
  /// legend: to the right of the plots or, if it is wide, below them on a
  /// higher canvas.
  /// @param height  of the room for the plots, if the usual canvas would leave
  ///                some of it empty
  explicit Canvas(std::string_view title,
                  const std::vector<LegendEntry>& legend = {},
                  std::optional<double> height = {});

  /// Room that is still free.
  const Box& room() const { return room_; }
  /// Height relative to the usual canvas without a legend below the plots.
  double stretch() const { return stretch_; }
  /// The title and the legend. The entries of a legend beside the plots stand
  /// at the heights of their curves' ends as far as there is room; without
  /// heights the legend is centred.
  std::string script(std::vector<double> heights = {}) const;

  /// A text with its anchor and its vertical middle at (x, y).
  std::string text(double x, double y, std::string_view text,
                   Anchor anchor = Anchor::center) const;
  /// Text upwards, in as many lines as needed; the middle of the last one is at
  /// x.
  std::string upward(double x, const Box& beside, std::string_view text) const;
  /// Room that upward() takes to the left of the middle of its last line.
  static double upward_width(double room, std::string_view text);
  /// Text above a plot, in as many lines as needed.
  std::string above(const Box& plot, std::string_view text) const;
  static double above_height(const Box& plot, std::string_view text);
  /// gnuplot's margins for a plot.
  std::string margins(const Box& plot) const;
  /// gnuplot's placement of the colour box.
  std::string colour_box(const Box& box) const;
  /// "X,Y" in gnuplot's screen coordinates.
  std::string at(double x, double y) const;

 private:
  std::string entry(double x, double y, const LegendEntry& of) const;

  Box room_;
  double stretch_ = 1;
  std::string script_;
  std::vector<LegendEntry> beside_;  // drawn to the right of the room
};

}  // namespace cli
