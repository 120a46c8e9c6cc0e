#pragma once

#include <Eigen/Core>

#include "libcontact/base/error.hpp"
#include "libcontact/joint/joint.hpp"

namespace contact::detail {

struct MinimaxFit {
  Eigen::VectorXd numbers;
  double error;  ///< the largest residual; of pairs the root of both squares
};

/// The numbers x with the least largest residual |A x - b|, to some per cent,
/// by least squares whose weights grow with the residuals (Lawson 1961).
/// @param rows_of_one  1, or 2: the upper and the lower half of the rows are
///                     components of one residual
MinimaxFit minimax_fit(Eigen::MatrixXd a, const Eigen::VectorXd& b,
                       int rows_of_one = 1, int rounds = 15);

/// @throws Error of a joint with rims or ends, which no load alone decides on
void check_endless(const Joint& joint);
/// @throws Error unless 0 < low < high
void check_loads(double low, double high);
/// A law with all its numbers has errors of `best`.
Error out_of_reach(double wanted, double best);

}  // namespace contact::detail
