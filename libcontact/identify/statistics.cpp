#include "libcontact/identify/statistics.hpp"

#include <Eigen/Core>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/linear/parts.hpp"
#include "libcontact/base/linear/solve.hpp"
#include "libcontact/base/root_finding.hpp"

namespace contact::detail {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Whether a search stopped because the range ends there, and not at a minimum.
// f0 and A may be 0.
bool is_at_end(const std::pair<double, double>& range, double x, int number) {
  constexpr double near = 1e-2;  // in the logarithm of a clearance
  if (number < 2) return x > (1 - near) * range.second;
  return x < range.first + near || x > range.second - near;
}

// With this f0 and a clearance at one end of its range, the better one.
Minimum least_at_ends(const MomentModel& model, const Measurements& measured,
                      double coefficient, Point start,
                      std::vector<int> others) {
  constexpr int clearance = 2;
  std::erase(others, clearance);
  Minimum least;
  const auto [lowest, highest] = model.range(clearance);
  for (const double end : {lowest, highest}) {
    start[0] = coefficient;
    start[clearance] = end;
    const Minimum found = least_squares(
        model, measured, VectorXd::Ones(model.size()), start, others);
    if (found.status != Status::ok) continue;
    if (least.status != Status::ok || found.chi2 < least.chi2) least = found;
  }
  return least;
}

// Largest distance of a number on one side, and the end of an interval that
// reaches it.
struct Side {
  double last;
  double bound;
};

// Zero of `excess`; NaN if it has no value there or jumps.
template <class Excess>
double zero_between(const Excess& excess, double low, double high,
                    double at_low, double at_high) {
  // 1e-6 of the value: far below what an interval means.
  constexpr int bits = 21;
  constexpr double negligible = 0.1;
  const double found =
      shrink_bracket(excess, low, high, at_low, at_high, bits).middle();
  return std::abs(excess(found)) < negligible ? found : nan;
}

// One end of the interval: where `excess`, which is -quantile at `best`, is 0,
// or else the bound on that side. Where refits fail, shorter steps may succeed;
// NaN if the last success was still inside.
template <class Excess>
double profile_end(const Excess& excess, double best, double step,
                   double quantile, Side side) {
  double near = best;
  double at_near = -quantile;
  const double shortest = 1e-3 * std::abs(step);
  bool has_failed = false;
  constexpr int most_steps = 60;
  for (int i = 0; i < most_steps && near != side.last; ++i) {
    const double far = step > 0 ? std::min(near + step, side.last)
                                : std::max(near + step, side.last);
    const double at_far = excess(far);
    if (std::isnan(at_far)) {
      has_failed = true;
      step /= 2;
      if (std::abs(step) < shortest) return nan;
    } else if (at_far >= 0) {
      return step > 0 ? zero_between(excess, near, far, at_near, at_far)
                      : zero_between(excess, far, near, at_far, at_near);
    } else {
      near = far;
      at_near = at_far;
      if (!has_failed) step *= 2;
    }
  }
  return near == side.last ? side.bound : nan;
}

}  // namespace

double student_quantile(double level, int degrees_of_freedom) {
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom),
                               (1 + level) / 2);
}

double chance_of(double chi2_per_degree, int degrees_of_freedom) {
  const double half = 0.5 * degrees_of_freedom;
  return chi2_per_degree > 1
             ? boost::math::gamma_q(half, half * chi2_per_degree)
             : boost::math::gamma_p(half, half * chi2_per_degree);
}

MatrixXd inverse_of_square(const MatrixXd& slopes) {
  if (slopes.cols() == 0) return MatrixXd(0, 0);
  const VectorXd size = slopes.colwise().norm().cwiseInverse();
  const MatrixXd scaled = slopes * size.asDiagonal();
  const MatrixXd inverse =
      solve_symmetric(scaled.transpose() * scaled,
                      MatrixXd::Identity(slopes.cols(), slopes.cols()));
  return size.asDiagonal() * inverse * size.asDiagonal();
}

double scaled_condition(const MatrixXd& slopes) {
  if (slopes.cols() == 0) return 1;
  const VectorXd values = singular_values(slopes.colwise().normalized());
  return values[0] / values[values.size() - 1];
}

double huber_factor(const VectorXd& residuals, int parameters) {
  const VectorXd psi = residuals.cwiseMax(-huber_limit).cwiseMin(huber_limit);
  const auto n = static_cast<double>(residuals.size());
  const double p = parameters;
  const double inside =
      static_cast<double>((residuals.array().abs() < huber_limit).count()) / n;
  const double correction = 1 + p * (1 - inside) / (n * inside);
  return correction * correction * psi.squaredNorm() / (n - p) /
         (inside * inside);
}

Estimate trend(const VectorXd& residuals, const VectorXd& over,
               const MatrixXd& slopes, double level) {
  Estimate slope;
  slope.value = std::numeric_limits<double>::quiet_NaN();
  const VectorXd centred = over.array() - over.mean();
  // Trends that the fit can follow do not count.
  VectorXd left = centred;
  if (slopes.cols() > 0) {
    left -= slopes * solve_least_squares(slopes, centred);
  }
  const auto n = static_cast<int>(residuals.size());
  const int degrees = n - static_cast<int>(slopes.cols()) - 1;
  // A spread of 1e-6 comes from rounded numbers, not from a plan of tests.
  const double spread = 1e-6 * over.norm();
  if (!(left.norm() > spread) || degrees < 1) return slope;
  slope.value = left.dot(residuals) / left.squaredNorm();
  const double rest = (residuals - slope.value * left).squaredNorm();
  slope.standard_error = std::sqrt(rest / degrees) / left.norm();
  const double reach = student_quantile(level, degrees) * slope.standard_error;
  slope.interval = {slope.value - reach, slope.value + reach};
  return slope;
}

Estimate::Interval profile(const MomentModel& model,
                           const Measurements& measured, const Minimum& best,
                           const std::vector<int>& free, int number,
                           const Point& linear, double step, double quantile,
                           int degrees_of_freedom) {
  std::vector<int> others = free;
  std::erase(others, number);
  const VectorXd weight = VectorXd::Ones(model.size());
  const double value = best.point[number];
  Point last = best.point;
  Point along = linear;
  const auto excess = [&](double trial) {
    // Errors of the others enter by their square.
    constexpr double tolerance = 1e-6;
    const auto refitted = [&](const Point& start) {
      return least_squares(model, measured, weight, start, others, tolerance);
    };
    const auto is_good = [&](const Minimum& found) {
      return found.status == Status::ok &&
             std::ranges::none_of(others, [&](int other) {
               return is_at_end(model.range(other), found.point[other], other);
             });
    };
    Minimum found = refitted(last + (trial - last[number]) * along);
    if (!is_good(found)) {
      Point start = best.point;
      start[number] = trial;
      found = refitted(start);
    }
    // Moments hardly depend on a clearance at an end of its range: f0 has an
    // end there as well. A has none, because they depend on the product alone.
    if (!is_good(found)) {
      if (number != 0 || std::ranges::count(others, 2) == 0) return nan;
      found = least_at_ends(model, measured, trial, best.point, others);
      if (found.status != Status::ok) return nan;
    }
    if (trial != last[number])
      along = (found.point - last) / (trial - last[number]);
    last = found.point;
    const double rise = (found.chi2 - best.chi2) * degrees_of_freedom;
    return std::sqrt(std::max(rise, 0.0) / best.chi2) - quantile;
  };
  // A little beyond the end of a linear model, so that it lies within.
  const double reach = 1.05 * quantile * step;
  const auto [lowest, highest] = model.range(number);
  Estimate::Interval ends;
  ends.high = profile_end(excess, value, reach, quantile, {highest, infinity});
  last = best.point;
  along = linear;
  // f0 and A end at 0.
  ends.low = profile_end(excess, value, -reach, quantile,
                         {lowest, number < 2 ? 0 : -infinity});
  return ends;
}

}  // namespace contact::detail
