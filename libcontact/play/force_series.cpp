#include "libcontact/play/force_series.hpp"

#include <algorithm>
#include <cmath>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/units.hpp"

namespace contact::detail {
namespace {

// Below it small contacts follow a power of the penetration.
constexpr double smallest_half_angle = 0.003;
constexpr double largest_half_angle = 80 * degree;
// The penetration grows without end towards the limit half-angle; here it is
// some hundred clearances.
constexpr double largest_share_of_limit = 0.999;

// Last coefficients of a fully resolved series; series of thin layers end in
// the roundings of the solver.
constexpr double negligible = 2e-13;

}  // namespace

ForceSeries::ForceSeries(JointKind kind, double limit, const Solver& solver)
    : power_(kind == JointKind::ball ? 3 : 2),
      limit_(limit),
      first_(std::log(smallest_half_angle)),
      last_(std::log(
          std::min(largest_half_angle, largest_share_of_limit * limit))) {
  for (int count = 64;; count *= 2) {
    series_ = tabulated(kind, count, solver);
    if (count == 256 || series_.is_resolved(negligible, depth)) break;
  }
}

ChebyshevTable ForceSeries::tabulated(JointKind kind, int count,
                                      const Solver& solver) const {
  // 1/mu or 1/lambda over x, and stiffness over K_1'/D'.
  const double load_unit = kind == JointKind::ball ? pi / 2 : 0.5;
  const double stiffness_unit = kind == JointKind::ball ? pi / 3 : pi / 4;
  return {count, [&](double half_phase) -> Eigen::RowVectorXd {
            const double u = (first_ + last_) / 2 +
                             (last_ - first_) / 2 * std::cos(2 * half_phase);
            const double theta = std::exp(u);
            const ForcePoint point = solver(theta);
            const double x = load_unit * point.reciprocal_load;
            const double shift = (power_ - 2) * u;
            Eigen::RowVectorXd row(depth + 1);
            row << std::log(x / (limit_ - theta)) + power_ * u,
                std::log(point.approach.approach * x) + shift,
                std::log(point.approach.stiffness / stiffness_unit) - shift,
                std::log(point.excess) - 2 * u, 0;
            row[depth] = row[approach] - row[reciprocal];
            return row;
          }};
}

double ForceSeries::variable(double u) const {
  return (2 * u - first_ - last_) / (last_ - first_);
}

ForceSeries::Point ForceSeries::at(double u) const {
  const double theta = std::exp(u);
  const double v = variable(u);
  const double x =
      (limit_ - theta) * std::exp(series_.value(reciprocal, v) - power_ * u);
  const double penetration =
      std::exp(series_.value(approach, v) - (power_ - 2) * u) / x;
  const double slope = std::exp(series_.value(stiffness, v) + (power_ - 2) * u);
  const double extra = std::exp(series_.value(excess, v) + 2 * u);
  return {theta, penetration, 1 / x, slope, (penetration - extra) / (2 * x)};
}

double ForceSeries::at_penetration(double penetration, double start) const {
  const double wanted = std::log(penetration);
  double u = start;
  // Newton's steps from the last point of a fine grid: two to four.
  constexpr int step_limit = 30;
  for (int i = 0; i < step_limit; ++i) {
    const double theta = std::exp(u);
    const double rest = limit_ - theta;
    const auto [value, slope] =
        series_.tangent(ForceSeries::depth, variable(u));
    const double error = value + 2 * u - std::log(rest) - wanted;
    const double growth = slope * 2 / (last_ - first_);
    const double next =
        std::clamp(u - error / (growth + 2 + theta / rest), first_, last_);
    const double step = std::abs(next - u);
    u = next;
    if (step < 1e-15 * std::abs(u)) break;
  }
  return u;
}

}  // namespace contact::detail
