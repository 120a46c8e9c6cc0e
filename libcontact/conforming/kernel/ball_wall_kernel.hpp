#pragma once

#include <span>
#include <vector>

namespace contact::detail {

/// Contribution of walls to the kernel of a ball's equation,
///
///     kappa_c(x) = sum_{n >= 0} (n + 1/2) Dc_n cos((n + 1/2) x),
///
/// a smooth even function with kappa_c(2 pi - x) = -kappa_c(x), as Chebyshev
/// series on panels whose widths grow with x. Absolute error below 1e-14 of
/// the largest value.
class BallWallKernel {
 public:
  /// @param correction  Dc_n, n = 0, 1, ...; the first one missing is 0
  /// @param thickness   of the thinner surface layer, over rho
  BallWallKernel(std::span<const double> correction, double thickness);

  /// @param x  [0, 2 pi]
  double operator()(double x) const;

 private:
  static constexpr int terms = 32;
  struct Panel {
    double end;
    double series[terms];
  };
  std::vector<Panel> panels_;
};

}  // namespace contact::detail
