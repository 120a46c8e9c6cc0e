#include "cli/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/gnuplot.hpp"
#include "cli/number.hpp"
#include "cli/picture/canvas.hpp"
#include "cli/picture/text_size.hpp"
#include "cli/refuse.hpp"
#include "libcontact/base/text.hpp"

namespace cli {
namespace {

// In plots/style.gp.
constexpr std::size_t plain_colours = 7;
// Longest label of a legend, in bytes.
constexpr std::size_t longest_label = 60;

// A plot among those over one x.
struct Stacked {
  Axis axis;
  Extent extent;
  double share = 1;   // share of the height
  bool whole = true;  // its axis ends with ticks
  std::string marks = {};
  std::string curves = {};  // arguments of `plot` for them
};

std::string style_of(const Curve& curve, std::size_t i, std::size_t count,
                     bool family) {
  const double part = static_cast<double>(i) /
                      static_cast<double>(std::max<std::size_t>(count - 1, 1));
  const std::string colour =
      family ? fmt::format("lw 2.5 lc palette frac {:.3f}", part)
             : fmt::format("lt {}", curve.colour > 0
                                        ? static_cast<std::size_t>(curve.colour)
                                        : i % plain_colours + 1);
  // Curves that repeat a colour are dotted.
  const int dashes = curve.dashed ? 2 : !family && i >= plain_colours ? 3 : 1;
  return fmt::format("{} dt {}", colour, dashes);
}

std::vector<LegendEntry> legend_of(const std::vector<Curve>& curves,
                                   bool family) {
  std::vector<LegendEntry> legend;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    legend.push_back(
        {contact::detail::printable(curves[i].label, longest_label),
         style_of(curves[i], i, curves.size(), family)});
  }
  return legend;
}

// The data of the curves, added to the script, and what `plot` says of them.
std::string add_curves(std::string& script, const std::string& name,
                       const std::vector<Curve>& curves, bool family,
                       const Prefix& x, const Prefix& y) {
  std::string lines;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Curve& curve = curves[i];
    script += fmt::format("${}{} << END\n", name, i);
    for (std::size_t j = 0; j < curve.x.size(); ++j) {
      script += number_text(x.factor * curve.x[j]) + ' ' +
                number_text(y.factor * curve.y[j]) + '\n';
    }
    script += "END\n";
    lines += fmt::format("{}${}{} using 1:2 with lines {}",
                         lines.empty() ? "" : ", \\\n  ", name, i,
                         style_of(curve, i, curves.size(), family));
  }
  return lines;
}

Extent all_of(const std::vector<Curve>& curves,
              std::vector<double> Curve::*values, bool logarithmic) {
  Extent all = extent_of(std::vector<double>(), logarithmic);
  for (const Curve& curve : curves) {
    all = joined(all, extent_of(curve.*values, logarithmic));
  }
  return all;
}

Extent scaled(const Extent& extent, const Prefix& prefix) {
  return {prefix.factor * extent.low, prefix.factor * extent.high};
}

constexpr double gap = 0.9;  // between plots, em

// Plots one above the other, x below the lowest.
// @param data  blocks that the plots read
std::string stack_script(const Canvas& canvas, std::string data, const Axis& x,
                         const Extent& x_extent, const std::string& x_label,
                         const std::vector<Stacked>& plots,
                         const std::vector<std::string>& labels) {
  const Box& room = canvas.room();
  double shares = 0;
  for (const Stacked& plot : plots) shares += plot.share;
  const double height = room.height() - under_axis - line_step / 2 -
                        gap * static_cast<double>(plots.size() - 1);
  std::vector<Ticks> ticks;
  std::vector<Box> boxes;
  double left = 0;
  double top = room.top + line_step / 2;  // half a number beyond the axis
  for (std::size_t i = 0; i < plots.size(); ++i) {
    const double own = height * plots[i].share / shares;
    boxes.push_back({0, 0, top, top + own});
    top += own + gap;
    ticks.push_back(
        ticks_of(plots[i].axis, plots[i].extent, Run::up, own, plots[i].whole));
    left = std::max(left, ticks.back().width() + beside_axis +
                              Canvas::upward_width(own + gap, labels[i]));
  }
  // The last number of x may reach half of itself beyond its axis.
  const double right = room.right - 1.2;
  const Ticks across =
      ticks_of(x, x_extent, Run::across, right - room.left - left, false);
  std::string script = std::move(data) + canvas.script() +
                       "unset key\nunset colorbox\nset multiplot\n" +
                       std::string(tick_style) +
                       (x.logarithmic ? "set logscale x\n" : "");
  for (std::size_t i = 0; i < plots.size(); ++i) {
    Box& box = boxes[i];
    box.left = room.left + left;
    box.right = right;
    const bool lowest = i + 1 == plots.size();
    script += canvas.margins(box) + across.script("x", lowest);
    if (lowest) {
      script += canvas.text((box.left + box.right) / 2,
                            box.bottom + under_axis - line_step / 2, x_label);
    }
    const Box beside{box.left, box.right, box.top - gap / 2,
                     box.bottom + gap / 2};
    script += (plots[i].axis.logarithmic ? "set logscale y\n"
                                         : "unset logscale y\n") +
              ticks[i].script("y") +
              canvas.upward(
                  room.left + Canvas::upward_width(beside.height(), labels[i]) -
                      line_step / 2,
                  beside, labels[i]) +
              plots[i].marks + "plot " + plots[i].curves +
              "\nunset label\nunset arrow\n";
  }
  return script + "unset multiplot\n";
}

// Places of the values that a picture of some 1,000 dots across can show: all,
// or of each stretch the lowest and the highest.
std::vector<std::size_t> shown(const std::vector<double>& y) {
  constexpr std::size_t stretches = 1000;
  const std::size_t length = std::max<std::size_t>(1, y.size() / stretches);
  std::vector<std::size_t> places;
  for (std::size_t first = 0; first < y.size(); first += length) {
    const std::size_t end = std::min(first + length, y.size());
    std::size_t low = first;
    std::size_t high = first;
    for (std::size_t i = first; i < end; ++i) {
      if (std::isnan(y[low]) || y[i] < y[low]) low = i;
      if (std::isnan(y[high]) || y[i] > y[high]) high = i;
    }
    places.push_back(std::min(low, high));
    if (low != high) places.push_back(std::max(low, high));
  }
  return places;
}

}  // namespace

void check_curves(std::size_t curves) {
  if (curves <= most_curves) return;
  refuse_without("--plot", fmt::format("at most {} curves; these are {}",
                                       most_curves, curves));
}

std::string draw(const LinePlot& plot, const std::string& file) {
  const Extent x_extent = all_of(plot.curves, &Curve::x, plot.x.logarithmic);
  const Extent y_extent = all_of(plot.curves, &Curve::y, plot.y.logarithmic);
  const Prefix x = prefix_of(plot.x, x_extent);
  const Prefix y = prefix_of(plot.y, y_extent);
  std::string data;
  std::vector<Stacked> plots = {
      {.axis = plot.y, .extent = scaled(y_extent, y)}};
  plots[0].curves = add_curves(data, "curve", plot.curves, plot.family, x, y);
  std::vector<std::string> labels = {label_of(plot.y, y)};
  if (plot.lower) {
    const double range = plot.lower->half_range;
    plots[0].share = 1.5;
    plots.push_back({.axis = plot.lower->y,
                     .extent = {-range, range},
                     .whole = false,
                     .curves = add_curves(data, "lower", plot.lower->curves,
                                          false, x, {})});
    labels.push_back(label_of(plot.lower->y, {}));
  }
  const Canvas canvas(plot.title, legend_of(plot.curves, plot.family));
  return draw_script(
      stack_script(canvas, std::move(data), plot.x, scaled(x_extent, x),
                   label_of(plot.x, x), plots, labels),
      file, canvas.stretch());
}

std::string draw(const PanelPlot& plot, const std::string& file) {
  const Extent x_extent = extent_of(plot.values, false);
  const Prefix x = prefix_of(plot.x, x_extent);
  std::string data;
  std::vector<Stacked> plots;
  std::vector<std::string> labels;
  for (const Panel& panel : plot.panels) {
    const std::size_t number = plots.size();
    Extent extent = joined(extent_of(panel.y, false), {0, 0});
    const Prefix y = prefix_of(panel.axis, extent);
    data += fmt::format("$panel{} << END\n", number);
    for (const std::size_t i : shown(panel.y)) {
      data += number_text(x.factor * plot.values[i]) + ' ' +
              number_text(y.factor * panel.y[i]) + '\n';
    }
    data += "END\n";
    Stacked& to = plots.emplace_back(
        Stacked{.axis = panel.axis, .extent = scaled(extent, y)});
    to.curves =
        fmt::format("$panel{} using 1:2 with lines lt {}", number, number + 1);
    if (panel.mark) {
      const double value = y.factor * panel.y[*panel.mark];
      to.marks = fmt::format(
          "set label '{:.3g}' at {},{} center front offset 0,-1 point pt 7 "
          "ps 0.6\n",
          value, number_text(x.factor * plot.values[*panel.mark]),
          number_text(value));
    }
    labels.push_back(label_of(panel.axis, y));
  }
  const Canvas canvas(plot.title);
  return draw_script(
      stack_script(canvas, std::move(data), plot.x, scaled(x_extent, x),
                   label_of(plot.x, x), plots, labels),
      file, canvas.stretch());
}

}  // namespace cli
