#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

namespace contact::detail {

/// Gauss-Legendre rule on [-1, 1], nodes increasing. For rules whose size is
/// known at run time only; relative error of the weights below 1e-14.
struct GaussLegendre {
  explicit GaussLegendre(int size);
  Eigen::VectorXd node;
  Eigen::VectorXd weight;
};

/// Row i: P_0(x_i), P_2(x_i), ..., P_{2 (count - 1)}(x_i).
Eigen::MatrixXd even_legendre(int count, const Eigen::VectorXd& x);

/// u'(v)/v for u = sum u_j P_{2j}(v), |v| <= 1: even in v, finite at 0. Kept
/// as a Chebyshev series in v^2.
class EvenLegendreSlope {
 public:
  static constexpr int max_terms = 64;
  /// @param coefficients  u_j, 2 to max_terms of them
  explicit EvenLegendreSlope(std::span<const double> coefficients);
  double operator()(double v) const;

 private:
  int terms_;
  std::array<double, max_terms> series_{};
};

}  // namespace contact::detail
