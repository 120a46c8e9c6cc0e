#pragma once

#include <array>
#include <span>

namespace contact {

/// Exact pressure of one contact as a short expansion:
///
///     p(theta) = sum a_k sin((2k+1) phi) + x^3 ln x sum b_k x^(2k),
///     x = sin phi = sqrt((cos theta - cos theta0)
///                        /((1 - c)(1 + 2c + cos theta))),  c = cos(theta0/2),
///
/// in units of R_n/rho^2 (ball) or P/rho (pin). It has the square-root edge of
/// the exact solution and its logarithm. A plain value: no allocation, no
/// exceptions; NaN gives NaN. All NaN if it was asked for outside its range.
class ContactPressure {
 public:
  static constexpr int max_terms = 64;
  static constexpr int logarithms = 3;

  /// @param half_angle    theta0, rad, (0, pi)
  /// @param force_ratio   S
  /// @param coefficients  a_k, at most max_terms
  /// @param logarithmic   b_k, at most `logarithms`
  ContactPressure(double half_angle, double force_ratio,
                  std::span<const double> coefficients,
                  std::span<const double> logarithmic);

  /// theta0, rad.
  double half_angle() const { return half_angle_; }
  /// p(theta); even in theta, 0 outside the contact.
  double pressure(double theta) const noexcept;
  /// -dp/dtheta per rad; odd in theta, infinite at the edge, 0 outside.
  double slope(double theta) const noexcept;
  /// The largest pressure, p(peak_angle()).
  double peak() const noexcept;
  /// Place of the peak, [0, theta0], rad: 0 but for thin walls with a free
  /// outer surface and for stiff thin walls on a soft medium, which bend alike.
  /// To 1e-8 of theta0.
  double peak_angle() const noexcept;
  /// Whether it falls from the centre to the edge: not always under such
  /// walls, also where the largest is at the centre.
  bool falls_outwards() const noexcept;
  /// S = ∫ p dS/R_n (ball), ∫ p rho dt/P (pin).
  double force_ratio() const noexcept { return force_ratio_; }
  /// a_0, a_1, ...
  std::span<const double> coefficients() const noexcept {
    return {coefficients_.data(), static_cast<std::size_t>(terms_)};
  }
  /// b_0, b_1, ...
  std::span<const double, logarithms> logarithmic() const noexcept {
    return logarithmic_;
  }

  /// dp/dx at many x.
  /// @param edge_square  x^2, [0, 1]
  /// @param out          as many slopes; may be the same array
  void edge_slopes(std::span<const double> edge_square,
                   std::span<double> out) const noexcept;

 private:
  template <class V>
  V pressure_at(const V& edge_square) const noexcept;
  template <class V>
  V slope_at(const V& edge_square) const noexcept;
  static constexpr int scan_steps = 32;
  double scan_angle(int i) const noexcept;

  double half_angle_;
  double force_ratio_;
  int terms_;
  std::array<double, max_terms> coefficients_{};
  std::array<double, logarithms> logarithmic_{};
};

}  // namespace contact
