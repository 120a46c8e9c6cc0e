#include "cli/plot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cli/gnuplot.hpp"
#include "cli/number.hpp"
#include "cli/refuse.hpp"
#include "libcontact/base/text.hpp"

namespace cli {
namespace {

// In plots/style.gp.
constexpr std::size_t plain_colours = 7;
// Of a legend, in bytes: from 60 on it lies over the curves, and from 100 on
// gnuplot leaves it out.
constexpr std::size_t longest_label = 40;

// The data of the curves, added to the script, and what `plot` says of them.
std::string add_curves(std::string& script, const std::string& name,
                       const std::vector<Curve>& curves, bool family) {
  std::string lines;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Curve& curve = curves[i];
    script += fmt::format("${}{} << END\n", name, i);
    for (std::size_t j = 0; j < curve.x.size(); ++j) {
      script += number_text(curve.x[j]) + ' ' + number_text(curve.y[j]) + '\n';
    }
    script += "END\n";
    const std::string colour =
        family
            ? fmt::format("lw 2.5 lc palette frac {:.3f}",
                          static_cast<double>(i) /
                              static_cast<double>(
                                  std::max<std::size_t>(curves.size() - 1, 1)))
            : fmt::format("lt {}", curve.colour > 0
                                       ? static_cast<std::size_t>(curve.colour)
                                       : i % plain_colours + 1);
    // What goes round the colours again is dotted.
    const int dashes = curve.dashed ? 2 : !family && i >= plain_colours ? 3 : 1;
    lines += fmt::format(
        "{}${}{} using 1:2 with lines {} dt {} title {}",
        lines.empty() ? "" : ", \\\n  ", name, i, colour, dashes,
        gnuplot_text(contact::detail::printable(curve.label, longest_label)));
  }
  return lines;
}

// Of the values that a logarithmic axis has a place for.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = 0;
};
Extent extent(const std::vector<Curve>& curves,
              std::vector<double> Curve::*values) {
  Extent all;
  for (const Curve& curve : curves) {
    for (const double value : curve.*values) {
      if (!(value > 0 && std::isnormal(value))) continue;
      all.low = std::min(all.low, value);
      all.high = std::max(all.high, value);
    }
  }
  return all;
}

// Where the axis is labelled; none for gnuplot's own labels, the decades.
std::vector<double> labels_within(const Extent& e) {
  std::vector<double> labels;
  if (e.high >= 1000 * e.low) return labels;
  if (e.high >= 10 * e.low) {  // 1, 2, 5, 10, ...: three or more
    const int first = static_cast<int>(std::floor(std::log10(e.low)));
    for (int decade = first; decade <= first + 3; ++decade) {
      for (const int digit : {1, 2, 5}) {
        labels.push_back(digit * std::pow(10, decade));
      }
    }
    return labels;
  }
  // Multiples of a round number: three to eight.
  const double largest_step = (e.high - e.low) / 3;
  const double power = std::pow(10, std::floor(std::log10(largest_step)));
  const double step = power * (largest_step >= 5 * power   ? 5
                               : largest_step >= 2 * power ? 2
                                                           : 1);
  // 1e-9 of a step: a rounding error before the end is the end.
  for (double n = std::ceil(e.low / step); n <= e.high / step + 1e-9; ++n) {
    labels.push_back(n * step);
  }
  return labels;
}

// Over the data and no further: gnuplot itself goes on to whole decades, and
// to one too many where it rounds the logarithm of a power of ten. For the same
// reason it loses labels at the very ends: 1e-9 is no width of a line.
std::string logarithmic_axis(char axis, const Extent& e) {
  std::string script =
      fmt::format("set logscale {0}\nset format {0} '%g'\n", axis);
  constexpr double beyond = 1e-9;
  if (!(e.high > (1 + beyond) * e.low)) return script;  // nothing to resolve
  script += fmt::format("set {}range [{}:{}]\n", axis,
                        number_text((1 - beyond) * e.low),
                        number_text((1 + beyond) * e.high));
  const std::vector<double> labels = labels_within(e);
  if (labels.empty()) return script;
  return script +
         fmt::format("set {}tics ({:.12g})\n", axis, fmt::join(labels, ", "));
}

// The upper panel's share and the room for text, as parts of the picture; the
// key of all laws in one column.
constexpr std::string_view upper_panel =
    "set multiplot\nset lmargin at screen 0.13\nset rmargin at screen 0.79\n"
    "set tmargin at screen 0.89\nset bmargin at screen 0.48\n"
    "set key spacing 1\nset format x ''\n";
constexpr std::string_view lower_panel =
    "unset title\nunset key\nset tmargin at screen 0.44\n"
    "set bmargin at screen 0.19\nset format x '%g'\n";

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

// A round number of which at most five make up the largest value: there is no
// room for more labels.
double label_step(double largest) {
  if (!(largest > 0)) return 1;
  const double step = largest / 5;
  const double power = std::pow(10, std::floor(std::log10(step)));
  for (const int digit : {1, 2, 5}) {
    if (digit * power >= step) return digit * power;
  }
  return 10 * power;
}

// A panel's data and axis; the prefix leaves its labels few digits.
std::string panel_script(const std::vector<double>& x, const Panel& panel,
                         std::size_t number) {
  double largest = 0;
  for (const double y : panel.y) largest = std::max(largest, y);
  const auto [unit, prefix] = largest >= 1e6   ? std::pair{1e6, "M"}
                              : largest >= 1e4 ? std::pair{1e3, "k"}
                                               : std::pair{1., ""};
  std::string script = fmt::format("$panel{} << END\n", number);
  for (const std::size_t i : shown(panel.y)) {
    script += number_text(x[i]) + ' ' + number_text(panel.y[i] / unit) + '\n';
  }
  script += "END\nunset label\n";
  if (panel.mark) {
    const double y = panel.y[*panel.mark] / unit;
    script += fmt::format(
        "set label '{:.3g}' at {},{} center front offset 0,-1 point pt 7 "
        "ps 0.6\n",
        y, number_text(x[*panel.mark]), number_text(y));
  }
  const std::string label =
      fmt::format("{}, {}{}", panel.label, prefix, panel.unit);
  return script + fmt::format(
                      "set ylabel {}\nset ytics {}\n"
                      "plot $panel{} using 1:2 with lines lt {}\n",
                      gnuplot_text(label), label_step(largest / unit), number,
                      number + 1);
}

}  // namespace

void check_curves(std::size_t curves) {
  if (curves <= most_curves) return;
  refuse_without("--plot", fmt::format("at most {} curves; these are {}",
                                       most_curves, curves));
}

std::string draw(const LinePlot& plot, const std::string& file) {
  std::string script;
  const std::string lines =
      add_curves(script, "curve", plot.curves, plot.family);
  script += fmt::format("set title {}\nset ylabel {}\nunset colorbox\n",
                        gnuplot_text(plot.title), gnuplot_text(plot.y_label));
  if (plot.logarithmic_x) {
    script += logarithmic_axis('x', extent(plot.curves, &Curve::x));
  }
  if (plot.logarithmic_y) {
    script += logarithmic_axis('y', extent(plot.curves, &Curve::y));
  }
  const std::string x_label =
      fmt::format("set xlabel {}\n", gnuplot_text(plot.x_label));
  if (!plot.lower) {
    // Beside long labels there is little room for the curves, above many.
    constexpr std::size_t long_label = 20;
    constexpr std::ptrdiff_t few = 4;
    const auto labels = [&plot](std::size_t size) {
      return std::ranges::count_if(plot.curves, [size](const Curve& curve) {
        return curve.label.size() > size;
      });
    };
    if (labels(long_label) > 0 && labels(0) <= few) {
      script += "set key outside bottom center Left reverse maxcols 1\n";
    }
    return draw_script(script + x_label + "plot " + lines + '\n', file);
  }
  const std::string lower =
      add_curves(script, "lower", plot.lower->curves, false);
  script += upper_panel;
  script += "plot " + lines + '\n';
  script += lower_panel;
  script += x_label;
  script += fmt::format("set ylabel {}\nset yrange [{}:{}]\nplot {}\n",
                        gnuplot_text(plot.lower->y_label),
                        number_text(-plot.lower->half_range),
                        number_text(plot.lower->half_range), lower);
  return draw_script(script + "unset multiplot\n", file);
}

std::string draw(const PanelPlot& plot, const std::string& file) {
  // Parts of the picture's height.
  constexpr double top = 0.89;
  constexpr double bottom = 0.19;
  constexpr double gap = 0.04;
  const double step =
      (top - bottom + gap) / static_cast<double>(plot.panels.size());
  std::string script = fmt::format(
      "set title {}\nset multiplot\nset lmargin at screen 0.16\n"
      "set rmargin at screen 0.96\nunset key\nset format x ''\n"
      "set yrange [0:*]\n",
      gnuplot_text(plot.title));
  if (!plot.x.empty() && plot.x.front() < plot.x.back()) {
    script += fmt::format("set xrange [{}:{}]\n", number_text(plot.x.front()),
                          number_text(plot.x.back()));
  }
  for (std::size_t i = 0; i < plot.panels.size(); ++i) {
    const double upper = top - step * static_cast<double>(i);
    script += fmt::format(
        "set tmargin at screen {:.4f}\nset bmargin at screen {:.4f}\n", upper,
        upper - step + gap);
    if (i + 1 == plot.panels.size()) {
      script += fmt::format("set format x '%g'\nset xlabel {}\n",
                            gnuplot_text(plot.x_label));
    }
    script += panel_script(plot.x, plot.panels[i], i) + "unset title\n";
  }
  return draw_script(script + "unset multiplot\n", file);
}

}  // namespace cli
