#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <utility>

#include "libcontact/base/error.hpp"
#include "libcontact/joint/joint.hpp"

namespace contact::detail {

struct MinimaxFit {
  Eigen::VectorXd numbers;
  double error;  ///< largest residual; for pairs the norm of both
};

/// Numbers x that minimise the largest residual |A x - b|, to some per cent, by
/// least squares with weights that grow with the residuals (Lawson 1961).
/// @param rows_of_one  1, or 2: the upper and the lower half of the rows are
///                     components of one residual
MinimaxFit minimax_fit(Eigen::MatrixXd a, const Eigen::VectorXd& b,
                       int rows_of_one = 1, int rounds = 15);

/// Columns y, x y, x^2 y, ...
Eigen::MatrixXd powers(const Eigen::ArrayXd& x, int count,
                       const Eigen::ArrayXd& y);
/// Points in (0, 1), denser at both ends.
Eigen::ArrayXd nodes(int count);

/// f0 and adhesion of dry friction, else 0: for other laws the caller knows f.
FrictionLaw dry_friction(const Joint& joint);
/// The given loads, or default loads as multiples of `unit`, of a joint whose
/// friction depends on the load alone.
/// @throws Error unless 0 < low < high, and for a joint with rims or ends
std::pair<double, double> loads_of_endless(
    const Joint& joint, const std::optional<std::pair<double, double>>& given,
    double unit, double low, double high);
/// @throws Error "WHAT requires OTHER" unless it has that
void require(bool is_met, std::string_view what, std::string_view other);
/// A number of the contact under a load.
/// @throws Error for NaN, where a law of the contact has no value
double checked(double number, double load);
/// Message for an error that a law with all its numbers, `best`, cannot reach.
Error out_of_reach(double wanted, double best);

}  // namespace contact::detail
