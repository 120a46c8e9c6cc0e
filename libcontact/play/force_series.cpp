#include "libcontact/play/force_series.hpp"

#include <algorithm>
#include <boost/math/special_functions/chebyshev.hpp>
#include <cmath>
#include <numbers>

#include "libcontact/base/units.hpp"

namespace contact::detail {
namespace {

constexpr double pi = std::numbers::pi;

// Below it small contacts follow a power of the penetration.
constexpr double smallest_half_angle = 0.003;
constexpr double largest_half_angle = 80 * degree;
// The penetration grows without end towards the limit half-angle; here it is
// some hundred clearances.
constexpr double largest_share_of_limit = 0.999;

// Last coefficients of a series that has all of its function; those of thin
// layers end in the roundings of the solver.
constexpr double negligible = 2e-13;

}  // namespace

ForceSeries::ForceSeries(JointKind kind, double limit, const Solver& solver)
    : power_(kind == JointKind::ball ? 3 : 2),
      limit_(limit),
      first_(std::log(smallest_half_angle)),
      last_(std::log(
          std::min(largest_half_angle, largest_share_of_limit * limit))) {
  for (int count = 64;; count *= 2) {
    tabulate(kind, count, solver);
    if (count == 256 || is_resolved()) break;
  }
}

void ForceSeries::tabulate(JointKind kind, int count, const Solver& solver) {
  // 1/mu or 1/lambda over x, and stiffness over K_1'/D'.
  const double load_unit = kind == JointKind::ball ? pi / 2 : 0.5;
  const double stiffness_unit = kind == JointKind::ball ? pi / 3 : pi / 4;
  for (Series* s : {&reciprocal_, &approach_, &stiffness_, &excess_}) {
    s->assign(count, 0);
  }
  for (int i = 0; i < count; ++i) {
    const double phi = pi * (i + 0.5) / count;
    const double u =
        (first_ + last_) / 2 + (last_ - first_) / 2 * std::cos(phi);
    const double theta = std::exp(u);
    const ForcePoint point = solver(theta);
    const double x = load_unit * point.reciprocal_load;
    const double shift = (power_ - 2) * u;
    const double values[] = {
        std::log(x / (limit_ - theta)) + power_ * u,
        std::log(point.approach.approach * x) + shift,
        std::log(point.approach.stiffness / stiffness_unit) - shift,
        std::log(point.excess) - 2 * u};
    for (int k = 0; k < count; ++k) {
      const double factor = 2.0 / count * std::cos(k * phi);
      reciprocal_[k] += factor * values[0];
      approach_[k] += factor * values[1];
      stiffness_[k] += factor * values[2];
      excess_[k] += factor * values[3];
    }
  }
  penetration_ = approach_;
  for (int k = 0; k < count; ++k) penetration_[k] -= reciprocal_[k];
  // c'_{k-1} = c'_{k+1} + 2 k c_k
  growth_.assign(count, 0);
  for (int k = count - 1; k > 0; --k) {
    const double beyond = k + 1 < count ? growth_[k + 1] : 0;
    growth_[k - 1] = beyond + 2 * k * penetration_[k];
  }
  for (double& c : growth_) c *= 2 / (last_ - first_);
}

bool ForceSeries::is_resolved() const {
  const auto ends = [](const Series& series) {
    return std::all_of(series.end() - 4, series.end(),
                       [](double c) { return std::abs(c) < negligible; });
  };
  return ends(reciprocal_) && ends(approach_) && ends(stiffness_) &&
         ends(excess_);
}

double ForceSeries::value(const Series& series, double u) const {
  const double v = (2 * u - first_ - last_) / (last_ - first_);
  return boost::math::chebyshev_clenshaw_recurrence(series.data(),
                                                    series.size(), v);
}

ForceSeries::Point ForceSeries::at(double u) const {
  const double theta = std::exp(u);
  const double x =
      (limit_ - theta) * std::exp(value(reciprocal_, u) - power_ * u);
  const double approach = std::exp(value(approach_, u) - (power_ - 2) * u);
  const double slope = std::exp(value(stiffness_, u) + (power_ - 2) * u);
  const double excess = std::exp(value(excess_, u) + 2 * u);
  const double penetration = approach / x;
  return {theta, penetration, 1 / x, slope, (penetration - excess) / (2 * x)};
}

double ForceSeries::at_penetration(double penetration, double start) const {
  const double wanted = std::log(penetration);
  double u = start;
  // Newton's steps from the last point of a fine grid: two to four.
  constexpr int step_limit = 30;
  for (int i = 0; i < step_limit; ++i) {
    const double theta = std::exp(u);
    const double rest = limit_ - theta;
    const double error =
        value(penetration_, u) + 2 * u - std::log(rest) - wanted;
    const double next = std::clamp(
        u - error / (value(growth_, u) + 2 + theta / rest), first_, last_);
    const double step = std::abs(next - u);
    u = next;
    if (step < 1e-15 * std::abs(u)) break;
  }
  return u;
}

}  // namespace contact::detail
