#pragma once

#include <Eigen/Core>

namespace contact::detail {

/// Gauss-Legendre rule on [-1, 1], nodes increasing. For rules whose size is
/// known at run time only; relative error of nodes and weights below 2.3e-16
/// for up to 512 nodes (base/gauss_legendre_test.cpp).
struct GaussLegendre {
  explicit GaussLegendre(int size);
  Eigen::VectorXd node;
  Eigen::VectorXd weight;
};

/// Row i: P_0(x_i), P_2(x_i), ..., P_{2 (count - 1)}(x_i).
Eigen::MatrixXd even_legendre(int count, const Eigen::VectorXd& x);

/// Row i: P_1(x_i), P_3(x_i), ..., P_{2 count - 1}(x_i).
Eigen::MatrixXd odd_legendre(int count, const Eigen::VectorXd& x);

/// Takes u_j, j < count, to the coefficients of the Chebyshev series in
/// 2 v^2 - 1 of u'(v)/v, u = sum u_j P_{2j}(v): even in v, finite at 0.
Eigen::MatrixXd even_legendre_slope(int count);

}  // namespace contact::detail
