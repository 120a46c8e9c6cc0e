#pragma once

#include <Eigen/Core>

#include "libcontact/identify/identify.hpp"
#include "libcontact/identify/least_squares.hpp"

namespace contact::detail {

/// Quantile of Student's t for both ends of an interval of this probability.
double student_quantile(double level, int degrees_of_freedom);

/// Probability of chi2/dof at least as far from 1 on its side.
double chance_of(double chi2_per_degree, int degrees_of_freedom);

/// (J^T J)^-1 of full rank, or NaN.
Eigen::MatrixXd inverse_of_square(const Eigen::MatrixXd& slopes);
/// Ratio of the largest and the smallest singular value after each column is
/// scaled to 1.
double scaled_condition(const Eigen::MatrixXd& slopes);
/// Factor of the inverse in the covariance of Huber's estimate.
/// @param residuals  over the scale
double huber_factor(const Eigen::VectorXd& residuals, int parameters);

/// The slope of residuals over something that the fit does not know: the
/// parameter that would be added.
/// @param slopes  of the residuals in the parameters of the fit
Estimate trend(const Eigen::VectorXd& residuals, const Eigen::VectorXd& over,
               const Eigen::MatrixXd& slopes, double level);

/// An interval by refitting, in units of the point.
/// @param best    a least sum of squares, its chi2 not 0
/// @param number  of the point
/// @param along   how the others go with it where the model is linear
/// @param step    a standard error, or of its size
Estimate::Interval profile(const MomentModel& model,
                           const Measurements& measured, const Minimum& best,
                           const std::vector<int>& free, int number,
                           const Point& along, double step, double quantile,
                           int degrees_of_freedom);

}  // namespace contact::detail
