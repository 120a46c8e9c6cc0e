#include "programs/identify/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "cli/gnuplot.hpp"
#include "cli/number.hpp"
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
double rate(const MeasuredMoment& datum) {
  return datum.angular_velocity.norm();
}

// The moment about Dw that turns the joint.
double torque(const MeasuredMoment& datum) {
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
    moments += line({load(d), b, rate(d), torque(d) / unit, d.sigma / unit});
    for (int i = 0; i < d.size(); ++i) {
      residuals += line({load(d), b, rate(d), fit.residual[at++]});
    }
  }
  return moments + "END\n" + residuals + "END\n";
}

// Directions of the curves: those of the data, or of many the two ends and the
// middle.
std::vector<double> directions(const FrictionFit& fit,
                               std::span<const MeasuredMoment> data) {
  if (fit.joint->geometry().kind() == contact::JointKind::pin) return {90};
  std::vector<double> all;
  for (const MeasuredMoment& d : data) {
    all.push_back(std::round(direction_deg(d)));
  }
  std::ranges::sort(all);
  // Clang 14 knows no ranges that algorithms return.
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

std::string upper_panel(const FrictionFit& fit,
                        std::span<const MeasuredMoment> data, double level) {
  const double radius = fit.joint->geometry().radius();
  const Range loads = range(data, load);
  const std::vector<double> all = directions(fit, data);
  std::string script;
  std::string bands;
  std::string lines;
  for (std::size_t i = 0; i < all.size(); ++i) {
    script += fmt::format("$fit{} << END\n{}END\n", i,
                          curve(fit, loads, all[i], level, radius));
    bands += fmt::format(
        "$fit{0} using 1:3:4 with filledcurves lt {1} fs transparent solid "
        "0.25 notitle, ",
        i, i + 1);
    lines += fmt::format(
        "$fit{} using 1:2 with lines lt {} title 'fit{}', ", i, i + 1,
        all.size() == 1 ? "" : fmt::format(", β = {}°", all[i]));
  }
  return script + fmt::format(
                      "set xrange [{}:{}]\nplot {}{}$data using 1:4:5 with "
                      "yerrorbars lc rgb '#333333' lw 1 pt 7 ps 0.35 title "
                      "'measured'\n",
                      cli::number_text(0.95 * loads.low),
                      cli::number_text(1.05 * loads.high), bands, lines);
}

// Some more, so that points are not on the frame.
Range wider(const Range& values) {
  const double margin = values.high > values.low
                            ? 0.05 * (values.high - values.low)
                            : 0.5 * std::max(values.high, 1.0);
  return {values.low - margin, values.high + margin};
}

// The panel of residuals over a column.
std::string residual_panel(int column, const Range& values, const char* label,
                           double left, double right) {
  return fmt::format(
      "set lmargin at screen {:.3f}\nset rmargin at screen {:.3f}\n"
      "set xlabel {}\nset xrange [{}:{}]\n"
      "plot 0 lt 7 lw 1 notitle, $residual using {}:4 with points lt 1 pt 7 ps "
      "0.35 notitle\nset ylabel ''\nset format y ''\n",
      left, right, cli::gnuplot_text(label), cli::number_text(values.low),
      cli::number_text(values.high), column);
}

}  // namespace

std::string draw_fit(const std::string& title, const FrictionFit& fit,
                     std::span<const MeasuredMoment> data, double level,
                     const std::string& file) {
  if (fit.status != contact::Status::ok) {
    return fmt::format("no picture {}: the fit has not converged", file);
  }
  std::string script =
      data_blocks(fit, data, fit.joint->geometry().radius()) +
      fmt::format(
          "set title {}\nset multiplot\nset lmargin at screen 0.13\n"
          "set rmargin at screen 0.78\nset tmargin at screen 0.90\n"
          "set bmargin at screen 0.56\nset logscale x\n"
          "set xlabel 'reaction R, N' offset 0,0.5\n"
          "set ylabel 'moment about Δω over ρR'\n",
          cli::gnuplot_text(title));
  script += upper_panel(fit, data, level);
  script +=
      "unset title\nset tmargin at screen 0.40\nset bmargin at screen 0.16\n"
      "set ylabel 'residual, σ'\n";
  script += "set xtics auto\n";
  const Range loads = range(data, load);
  script += residual_panel(1, {0.85 * loads.low, 1.15 * loads.high}, "R, N",
                           0.13, 0.38);
  script += "unset logscale x\n";
  script += residual_panel(2, wider(range(data, direction_deg)), "β, deg", 0.42,
                           0.67);
  script +=
      residual_panel(3, wider(range(data, rate)), "|Δω|, rad/s", 0.71, 0.96);
  return cli::draw_script(script + "unset multiplot\n", file);
}

}  // namespace hinge_identify
