#pragma once

#include <Eigen/Core>
#include <vector>

#include "libcontact/identify/moment_model.hpp"

namespace contact::detail {

/// Measured moments and their standard errors.
struct Measurements {
  Eigen::VectorXd moment;  ///< as MomentModel::moments()
  Eigen::VectorXd sigma;

  /// (model - measured)/sigma.
  Eigen::VectorXd residuals(const Eigen::VectorXd& model) const {
    return (model - moment).cwiseQuotient(sigma);
  }
};

/// Least sum of squares.
struct Minimum {
  Status status = Status::not_converged;
  Point point;
  /// Numbers of the point that were free and are not at their bound 0.
  std::vector<int> inside;
  double chi2 = 0;  ///< sum of weight residual^2
};

/// The least sum of weight residual^2 over some numbers of the point, f0 and A
/// not below 0, by Levenberg-Marquardt (MINPACK's lmder): what falls below 0 is
/// held there and the others are found anew.
/// @param tolerance  of the last step but one, relative; the last is its square
Minimum least_squares(const MomentModel& model, const Measurements& measured,
                      const Eigen::VectorXd& weight, const Point& start,
                      const std::vector<int>& free, double tolerance = 1e-10);

/// Median of |residual| over the median for normal errors of 1.
double robust_scale(const Eigen::VectorXd& residuals);

/// The least Huber loss at the scale robust_scale() of the same residuals, by
/// weights that are renewed until the point changes by 1e-11.
struct HuberMinimum : Minimum {
  double scale = 0;
  Eigen::VectorXd weight;
};
/// Residuals over the scale count linearly beyond this: 95 % of the precision
/// of least squares where errors are normal.
inline constexpr double huber_limit = 1.345;
HuberMinimum huber(const MomentModel& model, const Measurements& measured,
                   const Point& start, const std::vector<int>& free);

}  // namespace contact::detail
