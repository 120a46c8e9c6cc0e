#include "cli/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/gnuplot.hpp"
#include "cli/number.hpp"
#include "cli/picture/canvas.hpp"
#include "cli/picture/text_size.hpp"
#include "cli/refuse.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/text.hpp"

namespace cli {
namespace {

// As in plots/style.gp.
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
  std::string curves = {};        // arguments of `plot` for them
  std::vector<double> ends = {};  // values at the ends of labelled curves

  // Heights of the ends, em from the top; none if all are equal, such as
  // pressures, which end at 0.
  std::vector<double> heights_of_ends(const Box& box,
                                      const Ticks& ticks) const {
    std::vector<double> heights;
    for (const double end : ends) {
      heights.push_back(box.bottom -
                        box.height() * ticks.share(end, axis.logarithmic));
    }
    const auto [high, low] = std::ranges::minmax_element(heights);
    if (heights.empty() || *low - *high < line_step / 2) return {};
    return heights;
  }
};

// True if two curves are indistinguishable over more than half of their common
// range.
bool coincide(const Curve& a, const Curve& b, const Extent& y,
              bool logarithmic) {
  constexpr double near = 0.006;  // share of the axis, about a line's width
  const auto at = [&](double value) {
    return logarithmic ? std::log(value) / std::log(y.high / y.low)
                       : value / (y.high - y.low);
  };
  const std::size_t size = std::min(a.x.size(), b.x.size());
  if (!std::equal(a.x.begin(), a.x.begin() + size, b.x.begin())) return false;
  std::size_t both = 0;
  std::size_t close = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const double apart = std::abs(at(a.y[i]) - at(b.y[i]));
    if (std::isfinite(apart)) ++both;
    if (apart < near) ++close;
  }
  return 2 * close > both;
}

// gnuplot's style of each curve. A curve that lies on an earlier one is dashed;
// the dashes begin at its start and leave gaps for all curves below it.
std::vector<std::string> styles_of(const std::vector<Curve>& curves,
                                   bool family, const Extent& y,
                                   bool logarithmic) {
  constexpr std::size_t part = 10;  // in widths of a line
  const std::size_t count = curves.size();
  std::vector<std::size_t> under(count);
  std::vector<std::size_t> place(count, 0);
  std::vector<std::size_t> all(count, 1);
  for (std::size_t i = 0; i < count; ++i) {
    under[i] = i;
    for (std::size_t j = 0; j < i && under[i] == i; ++j) {
      if (under[j] != j || curves[i].dashed || curves[j].dashed) continue;
      if (!coincide(curves[j], curves[i], y, logarithmic)) continue;
      under[i] = j;
      place[i] = all[j]++;
    }
  }
  std::vector<std::string> styles;
  for (std::size_t i = 0; i < count; ++i) {
    const auto colour = static_cast<std::size_t>(curves[i].colour);
    const std::size_t most = std::max<std::size_t>(count - 1, 1);
    styles.push_back(
        family ? fmt::format("lw 2.5 lc palette frac {:.3f}",
                             static_cast<double>(i) / static_cast<double>(most))
               : fmt::format("lt {}",
                             colour > 0 ? colour : i % plain_colours + 1));
    styles.back() +=
        curves[i].dashed ? " dt 2"
        : place[i] > 0
            ? fmt::format(" dt ({},{})", part * (all[under[i]] - place[i]),
                          part * place[i])
        // Curves that repeat a colour are dotted.
        : !family && i >= plain_colours ? " dt 3"
                                        : " dt 1";
  }
  return styles;
}

// Adds the data of the curves to the script; returns their arguments of `plot`.
std::string add_curves(std::string& script, const std::string& name,
                       const std::vector<Curve>& curves,
                       const std::vector<std::string>& styles, const Prefix& x,
                       const Prefix& y) {
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
                         lines.empty() ? "" : ", \\\n  ", name, i, styles[i]);
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

// The last value that is a number, else NaN.
double end_of(const Curve& curve) {
  const auto last = std::find_if(curve.y.rbegin(), curve.y.rend(),
                                 [](double y) { return std::isfinite(y); });
  return last == curve.y.rend() ? contact::detail::nan : *last;
}

Extent scaled(const Extent& extent, const Prefix& prefix) {
  return {prefix.factor * extent.low, prefix.factor * extent.high};
}

constexpr double gap = 0.9;  // between plots, em

// Stacks plots; only the lowest one has labels on x.
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
  // Half of the last number of x may stand beyond the axis.
  const double right = room.right - 1.2;
  const Ticks across =
      ticks_of(x, x_extent, Run::across, right - room.left - left, false);
  const auto heights = plots[0].heights_of_ends(boxes[0], ticks[0]);
  std::string script = std::move(data) + canvas.script(heights) +
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

// Indices of the values that a picture about 1,000 dots wide can show: all of
// them, or the lowest and highest of each stretch.
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

bool is_wide(const std::vector<Curve>& curves) {
  constexpr double wide = 50;
  const Extent all = all_of(curves, &Curve::y, false);
  return all.low > 0 && all.high > wide * all.low;
}

std::string draw(const LinePlot& plot, const std::string& file) {
  const Extent x_extent = all_of(plot.curves, &Curve::x, plot.x.logarithmic);
  const Extent y_extent = all_of(plot.curves, &Curve::y, plot.y.logarithmic);
  const Prefix x = prefix_of(plot.x, x_extent);
  const Prefix y = prefix_of(plot.y, y_extent);
  std::string data;
  std::vector<Stacked> plots = {
      {.axis = plot.y, .extent = scaled(y_extent, y)}};
  const auto styles =
      styles_of(plot.curves, plot.family, y_extent, plot.y.logarithmic);
  plots[0].curves = add_curves(data, "curve", plot.curves, styles, x, y);
  std::vector<LegendEntry> legend;
  for (std::size_t i = 0; i < styles.size(); ++i) {
    const Curve& curve = plot.curves[i];
    if (curve.label.empty()) continue;
    legend.push_back(
        {contact::detail::printable(curve.label, longest_label), styles[i]});
    plots[0].ends.push_back(y.factor * end_of(curve));
  }
  std::vector<std::string> labels = {label_of(plot.y, y)};
  if (plot.lower) {
    const double range = plot.lower->half_range;
    const auto& curves = plot.lower->curves;
    plots[0].share = 1.5;
    plots.push_back(
        {.axis = plot.lower->y,
         .extent = {-range, range},
         .whole = false,
         .curves = add_curves(data, "lower", curves,
                              styles_of(curves, false, {-range, range}, false),
                              x, {})});
    labels.push_back(label_of(plot.lower->y, {}));
  }
  const Canvas canvas(plot.title, legend);
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
