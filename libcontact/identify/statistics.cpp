#include "libcontact/identify/statistics.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "libcontact/base/root_finding.hpp"

namespace contact::detail {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double infinity = std::numeric_limits<double>::infinity();

// One end of the interval: where `excess`, which is -quantile at `best`, is 0,
// or else the bound on that side, 0 or infinite.
template <class Excess>
double profile_end(const Excess& excess, double best, double step,
                   double quantile, double bound) {
  double near = best;
  double at_near = -quantile;
  constexpr int most_steps = 30;
  for (int i = 0; i < most_steps && near != bound; ++i, step *= 2) {
    const double far =
        step > 0 ? std::min(near + step, bound) : std::max(near + step, bound);
    const double at_far = excess(far);
    if (std::isnan(at_far)) return bound;
    if (at_far >= 0) {
      // 1e-6 of the value: far below what an interval means.
      constexpr int bits = 21;
      return step > 0 ? shrink_bracket(excess, near, far, at_near, at_far, bits)
                            .middle()
                      : shrink_bracket(excess, far, near, at_far, at_near, bits)
                            .middle();
    }
    near = far;
    at_near = at_far;
  }
  return bound;
}

}  // namespace

double student_quantile(double level, int degrees_of_freedom) {
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom),
                               (1 + level) / 2);
}

MatrixXd inverse_of_square(const MatrixXd& slopes) {
  if (slopes.cols() == 0) return MatrixXd(0, 0);
  const VectorXd size = slopes.colwise().norm().cwiseInverse();
  const MatrixXd scaled = slopes * size.asDiagonal();
  const MatrixXd inverse =
      (scaled.transpose() * scaled)
          .ldlt()
          .solve(MatrixXd::Identity(slopes.cols(), slopes.cols()));
  return size.asDiagonal() * inverse * size.asDiagonal();
}

double scaled_condition(const MatrixXd& slopes) {
  if (slopes.cols() == 0) return 1;
  const VectorXd values =
      slopes.colwise().normalized().bdcSvd().singularValues();
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
  // What the fit could follow is no trend.
  VectorXd left = centred;
  if (slopes.cols() > 0) {
    left -= slopes * slopes.colPivHouseholderQr().solve(centred);
  }
  const auto n = static_cast<int>(residuals.size());
  const int degrees = n - static_cast<int>(slopes.cols()) - 1;
  // A spread of 1e-6 is that of rounded numbers, not of a plan of tests.
  const double spread = 1e-6 * over.norm();
  if (!(left.norm() > spread) || degrees < 1) return slope;
  slope.value = left.dot(residuals) / left.squaredNorm();
  const double rest = (residuals - slope.value * left).squaredNorm();
  slope.standard_error = std::sqrt(rest / degrees) / left.norm();
  const double reach = student_quantile(level, degrees) * slope.standard_error;
  slope.interval = {slope.value - reach, slope.value + reach};
  return slope;
}

ConfidenceInterval profile(const MomentModel& model,
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
    const Point start = last + (trial - last[number]) * along;
    // What this leaves of the others counts by its square.
    constexpr double tolerance = 1e-6;
    const Minimum found =
        least_squares(model, measured, weight, start, others, tolerance);
    if (found.status != Status::ok) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    if (trial != last[number])
      along = (found.point - last) / (trial - last[number]);
    last = found.point;
    const double rise = (found.chi2 - best.chi2) * degrees_of_freedom;
    return std::sqrt(std::max(rise, 0.0) / best.chi2) - quantile;
  };
  // A little beyond the end of a linear model, so that it lies within.
  const double reach = 1.05 * quantile * step;
  ConfidenceInterval ends;
  ends.high = profile_end(excess, value, reach, quantile, infinity);
  last = best.point;
  along = linear;
  // The logarithm of a clearance has no bound.
  ends.low =
      profile_end(excess, value, -reach, quantile, number == 2 ? -infinity : 0);
  return ends;
}

}  // namespace contact::detail
