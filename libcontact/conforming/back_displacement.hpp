#pragma once

#include <array>

#include "libcontact/base/chebyshev_table.hpp"

namespace contact::detail {

/// Radial displacement of a ball by a uniform normal pressure on the cap of
/// half-angle psi about the pole theta = pi, after the Abel transform:
///
///     (2/pi) sum_{n != 1} s_n(nu) q_n cos((n + 1/2) f)
///
/// with q_n the Legendre coefficients of the pressure whose resultant is
/// pi rho^2. Smooth for |f| < pi - psi.
///
/// s_n is the integral of sigma(s) exp(-(n + 1/2) s) over s > 0, and the sum
/// of q_n exp(-(n + 1/2) w) has a closed form: a quadrature over s replaces a
/// series that barely converges. Its values are kept as a Chebyshev series for
/// |f| < 0.8 (pi - psi). Absolute error below 1e-12 for f < pi - psi - 0.1
/// (conforming/ball_test.cpp, against the series).
class BackDisplacement {
 public:
  /// @param poissons_ratio    nu of the ball, [0, 0.5]
  /// @param patch_half_angle  psi, rad, [0, pi/2]; 0 is a point force
  BackDisplacement(double poissons_ratio, double patch_half_angle);

  /// @param f  rad, |f| < pi - psi
  double operator()(double f) const;

  /// End of the Chebyshev series, 0.8 (pi - psi), rad.
  double series_end() const { return series_end_; }

 private:
  double by_quadrature(double f) const;

  // Beyond s = 2.5 the harmonics n >= 16 have nothing left (1e-16); those
  // below are completed one by one.
  static constexpr double upper_end = 2.5;
  static constexpr int head_terms = 16;
  static constexpr int nodes = 48;

  // The singularity at f = pi - psi lies so far beyond the end of the series
  // in f^2 that it converges like 4^-k.
  static constexpr int series_terms = 28;

  double cosine_patch_;
  double series_end_;
  ChebyshevTable series_;
  std::array<double, nodes> decay_;       // exp(-s)
  std::array<double, nodes> half_decay_;  // exp(-s/2)
  std::array<double, nodes> weight_;      // quadrature, times sigma(s)
  std::array<double, head_terms> head_;   // terms of cos((n + 1/2) f)
};

}  // namespace contact::detail
