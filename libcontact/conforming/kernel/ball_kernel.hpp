#pragma once

#include <array>
#include <span>

namespace contact::detail {

/// Elastic constants of a ball in a seat as the exact solution needs them.
struct BallConstants {
  double inner_share;    ///< w_1
  double inner_poisson;  ///< nu_1
  double outer_share;    ///< w_2
  double outer_poisson;  ///< nu_2
};

/// Compliance of the n-th Legendre harmonic of a ball, s_n(nu), and of a
/// spherical cavity, e_n(nu), in units of (4 rho/E) w_i; n = 0, 2, 3, ...
double ball_compliance(int n, double poissons_ratio);
double cavity_compliance(int n, double poissons_ratio);

/// The kernel of the Abel-transformed equation of a ball in a seat,
///
///     kappa(x) = sum_{n >= 0} d_n cos((n + 1/2) x),
///     d_n = (n + 1/2) (w_1 s_n + w_2 e_n) - 1,  d_1 = 0,
///
/// summed once for an elastic pair. d_n is a rational function of N = n + 1/2
/// that tends to 0 like 1/N; its first eight powers of 1/N are summed in
/// closed form (a logarithm times a polynomial, and power series), the rest
/// falls like N^-9 and is summed to N = 64.
class BallKernel {
 public:
  explicit BallKernel(const BallConstants& constants);

  /// The kernel of the same contact's equation for its gap,
  ///
  ///     kappa_e(x) = sum_{n >= 2} e_n cos((n + 1/2) x),  e_n = 1/(1 + d_n)
  ///     - 1.
  static BallKernel of_gap(const BallConstants& constants);

  /// kappa at many x in (0, 2 pi); absolute error below 1e-14
  /// (conforming/ball_test.cpp, against partial fractions in 30 digits).
  void evaluate(std::span<const double> x, std::span<double> kappa) const;

  /// A in kappa(x) = -A ln x + ..., x -> 0.
  double log_coefficient() const { return -logarithmic_[0]; }

 private:
  // 25 terms reach 1e-15 at x = pi: the series converge within 2 pi.
  static constexpr int series_terms = 25;
  static constexpr int powers = 8;
  static constexpr int direct_terms = 64;

  using Powers = std::array<double, powers>;
  using Direct = std::array<double, direct_terms>;
  /// @param q       of N^-1, N^-2, ... in the harmonics
  /// @param direct  the first harmonics
  BallKernel(const Powers& q, const Direct& direct);

  std::array<double, series_terms> even_{};     // powers of x^2
  std::array<double, powers / 2> logarithmic_;  // powers of x^2, times ln x
  std::array<double, powers / 2> odd_;          // powers of x^2, times x
  Direct direct_;                               // terms of cos((n + 1/2) x)
};

}  // namespace contact::detail
