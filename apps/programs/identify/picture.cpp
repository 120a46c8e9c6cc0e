#include "programs/identify/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cli/gnuplot.hpp"
#include "cli/number.hpp"
#include "cli/picture/axis.hpp"
#include "cli/picture/canvas.hpp"
#include "cli/picture/text_size.hpp"
#include "libcontact/base/units.hpp"
#include "programs/identify/report.hpp"

namespace hinge_identify {
namespace {

using contact::FrictionFit;
using contact::MeasuredMoment;
using Eigen::Vector3d;

struct Range {
  double low;
  double high;
};
template <class Of>
Range range(std::span<const MeasuredMoment> data, const Of& of) {
  const auto [low, high] = std::ranges::minmax(data, {}, of);
  return {of(low), of(high)};
}

double load(const MeasuredMoment& datum) { return datum.reaction.norm(); }
double rate_of(const MeasuredMoment& datum) {
  return datum.angular_velocity.norm();
}

// The moment about Dw that turns the joint.
double torque_of(const MeasuredMoment& datum) {
  if (!datum.is_vector()) return std::get<double>(datum.moment);
  return -std::get<Vector3d>(datum.moment)
              .dot(datum.angular_velocity.normalized());
}

std::string line(std::initializer_list<double> numbers) {
  std::string text;
  for (const double x : numbers) text += cli::number_text(x) + ' ';
  return text + '\n';
}

// Load, direction, rate, torque over rho R and its error; a line for each
// residual: load, direction, rate, residual.
std::string data_blocks(const FrictionFit& fit,
                        std::span<const MeasuredMoment> data, double radius) {
  std::string moments = "$data << END\n";
  std::string residuals = "$residual << END\n";
  Eigen::Index at = 0;
  for (const MeasuredMoment& d : data) {
    const double b = direction_deg(d);
    const double unit = radius * load(d);
    moments +=
        line({load(d), b, rate_of(d), torque_of(d) / unit, d.sigma / unit});
    for (int i = 0; i < d.size(); ++i) {
      residuals += line({load(d), b, rate_of(d), fit.residual[at++]});
    }
  }
  return moments + "END\n" + residuals + "END\n";
}

// Directions of the curves: the data's directions or, if there are many, both
// ends and the middle.
std::vector<double> directions(const FrictionFit& fit,
                               std::span<const MeasuredMoment> data) {
  if (fit.joint->geometry().kind() == contact::JointKind::pin) return {90};
  std::vector<double> all;
  for (const MeasuredMoment& d : data) {
    all.push_back(std::round(direction_deg(d)));
  }
  std::ranges::sort(all);
  // Clang 14 does not support subranges returned by range algorithms.
  all.erase(std::unique(all.begin(), all.end()), all.end());
  constexpr std::size_t most = 4;
  if (all.size() <= most) return all;
  return {all.front(), all[all.size() / 2], all.back()};
}

// Load, moment of the fit over rho R and the ends of its band.
std::string curve(const FrictionFit& fit, const Range& loads, double b_deg,
                  double level, double radius) {
  constexpr int points = 60;
  const double b = b_deg * contact::degree;
  std::string text;
  for (int i = 0; i <= points; ++i) {
    const double force =
        loads.low * std::pow(loads.high / loads.low, double(i) / points);
    const contact::Estimate moment =
        fit.predicted_moment(force * Vector3d(std::sin(b), 0, std::cos(b)),
                             Vector3d::UnitZ(), level);
    const double unit = radius * force;
    text += line({force, moment.value / unit, moment.interval.low / unit,
                  moment.interval.high / unit});
  }
  return text;
}

// Range of a panel's x axis, widened so that no point lies on the frame.
cli::Extent wider(const cli::Extent& values, bool logarithmic) {
  if (logarithmic) return {0.95 * values.low, 1.05 * values.high};
  const double margin = values.high > values.low
                            ? 0.05 * (values.high - values.low)
                            : 0.5 * std::max(values.high, 1.0);
  return {values.low - margin, values.high + margin};
}

// A panel of the picture: its box and its axes.
struct Panel {
  cli::Box box;
  cli::Axis x;
  cli::Ticks across;
  cli::Prefix prefix = {};

  Panel(const cli::Box& place, cli::Axis axis, const cli::Extent& values)
      : box(place), x(std::move(axis)) {
    const cli::Extent shown = wider(values, x.logarithmic);
    prefix = prefix_of(x, shown);
    across =
        ticks_of(x, {prefix.factor * shown.low, prefix.factor * shown.high},
                 cli::Run::across, box.width(), false);
  }
  // Everything except the plot itself.
  std::string script(const cli::Canvas& canvas) const {
    return canvas.margins(box) + across.script("x") +
           (x.logarithmic ? "set logscale x\n" : "unset logscale x\n") +
           canvas.text((box.left + box.right) / 2,
                       box.bottom + cli::under_axis - cli::line_step / 2,
                       label_of(x, prefix));
  }
};

struct Fitted {
  std::string data;
  std::string plot;
  std::vector<cli::LegendEntry> legend;
};
Fitted fitted(const FrictionFit& fit, std::span<const MeasuredMoment> data,
              double level) {
  const double radius = fit.joint->geometry().radius();
  const Range loads = range(data, load);
  const std::vector<double> all = directions(fit, data);
  Fitted to;
  std::string lines;
  for (std::size_t i = 0; i < all.size(); ++i) {
    to.data += fmt::format("$fit{} << END\n{}END\n", i,
                           curve(fit, loads, all[i], level, radius));
    to.plot += fmt::format(
        "$fit{0} using ($1*k):3:4 with filledcurves lt {1} fs transparent "
        "solid 0.25, ",
        i, i + 1);
    lines += fmt::format("$fit{} using ($1*k):2 with lines lt {}, ", i, i + 1);
    to.legend.push_back(
        {"fit" + (all.size() == 1 ? "" : fmt::format(", β = {}°", all[i])),
         fmt::format("lt {}", i + 1)});
  }
  constexpr const char* point = "lc rgb '#333333' lw 1 pt 7 ps 0.35";
  to.plot +=
      fmt::format("{}$data using ($1*k):4:5 with yerrorbars {}", lines, point);
  to.legend.push_back(
      {"measured", "lc rgb '#333333' lw 1", "pt 7 ps 0.35 lc rgb '#333333'"});
  return to;
}

// Range of the moments with their errors over rho R.
cli::Extent moments(std::span<const MeasuredMoment> data, double radius) {
  std::vector<double> all;
  for (const MeasuredMoment& d : data) {
    const double unit = radius * load(d);
    all.push_back((torque_of(d) - d.sigma) / unit);
    all.push_back((torque_of(d) + d.sigma) / unit);
  }
  return cli::extent_of(all, false);
}

// The residuals over what varies of load, direction and rate, side by side in a
// box.
std::string residual_panels(const cli::Canvas& canvas, const cli::Box& box,
                            const cli::Ticks& residuals,
                            std::span<const MeasuredMoment> data) {
  constexpr double gap = 2.2;  // between numbers at the ends of neighbours
  struct Over {
    int column;
    cli::Axis axis;
    Range values;
  };
  std::vector<Over> panels = {{1, {"R", "N", true}, range(data, load)},
                              {2, {"β", "deg"}, range(data, direction_deg)},
                              {3, {"|Δω|", "rad/s"}, range(data, rate_of)}};
  std::erase_if(panels, [](const Over& over) {
    return over.column > 1 && !(over.values.high > over.values.low);
  });
  const auto count = static_cast<double>(panels.size());
  const double width = (box.width() - (count - 1) * gap) / count;
  std::string script;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const double left = box.left + static_cast<double>(i) * (width + gap);
    const Panel panel({left, left + width, box.top, box.bottom}, panels[i].axis,
                      {panels[i].values.low, panels[i].values.high});
    script += panel.script(canvas) + residuals.script("y", i == 0) +
              fmt::format(
                  "plot 0 lt 7 lw 1, $residual using (${}*{}):4 with points lt "
                  "1 pt 7 ps 0.35\nunset label\n",
                  panels[i].column, cli::number_text(panel.prefix.factor));
  }
  return script;
}

}  // namespace

std::string draw_fit(const std::string& title, const FrictionFit& fit,
                     std::span<const MeasuredMoment> data, double level,
                     const std::string& file) {
  if (fit.status != contact::Status::ok) {
    return fmt::format("no picture {}: the fit has not converged", file);
  }
  const double radius = fit.joint->geometry().radius();
  const Fitted curves = fitted(fit, data, level);
  const cli::Canvas canvas(title, curves.legend);
  const cli::Box& room = canvas.room();
  const double height = room.height() - 2 * cli::under_axis - 2;
  const cli::Box above{0, 0, room.top + 0.7, room.top + 0.7 + 0.6 * height};
  const cli::Box below{0, 0, above.bottom + cli::under_axis + 0.7,
                       room.bottom - cli::under_axis};
  const std::vector<double> residuals(fit.residual.begin(), fit.residual.end());
  const cli::Ticks upper =
      ticks_of({}, moments(data, radius), cli::Run::up, above.height(), true);
  const cli::Ticks lower = ticks_of({}, cli::extent_of(residuals, false),
                                    cli::Run::up, below.height(), true);
  constexpr const char* moment_label = "moment about Δω over ρR";
  const double labels = cli::Canvas::upward_width(above.height(), moment_label);
  const double left = room.left + cli::beside_axis +
                      std::max(upper.width(), lower.width()) + labels;
  const double right = room.right - 1;
  const Panel panel({left, right, above.top, above.bottom},
                    {"reaction R", "N", true},
                    {range(data, load).low, range(data, load).high});
  const double label_at = room.left + labels - cli::line_step / 2;
  std::string script =
      data_blocks(fit, data, radius) + curves.data + canvas.script() +
      fmt::format("k = {}\n", cli::number_text(panel.prefix.factor)) +
      "unset key\nset multiplot\n" + std::string(cli::tick_style) +
      panel.script(canvas) + upper.script("y") +
      canvas.upward(label_at, above, moment_label) + "plot " + curves.plot +
      "\nunset label\nunset arrow\n" +
      canvas.upward(label_at, below, "residual, σ") +
      residual_panels(canvas, {left, right, below.top, below.bottom}, lower,
                      data);
  return cli::draw_script(script + "unset multiplot\n", file, canvas.stretch());
}

}  // namespace hinge_identify
