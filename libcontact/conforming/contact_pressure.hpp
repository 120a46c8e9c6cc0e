#pragma once

#include <array>
#include <span>

namespace contact {

/// Exact pressure of one contact as a short expansion:
///
///     p(theta) = sum a_k sin((2k+1) phi),  cos phi =
///     tan(theta/2)/tan(theta0/2)
///
/// in units of R_n/rho^2 (ball) or P/rho (pin). It has the square-root edge of
/// the exact solution. A plain value: no allocation, no exceptions; NaN gives
/// NaN. All NaN if it was asked for outside its range.
class ContactPressure {
 public:
  static constexpr int max_terms = 32;

  /// @param half_angle    theta0, rad, (0, pi)
  /// @param force_ratio   S
  /// @param coefficients  a_k, at most max_terms
  ContactPressure(double half_angle, double force_ratio,
                  std::span<const double> coefficients);

  /// theta0, rad.
  double half_angle() const { return half_angle_; }
  /// p(theta); even in theta, 0 outside the contact.
  double pressure(double theta) const noexcept;
  /// -dp/dtheta per rad; odd in theta, infinite at the edge, 0 outside.
  double slope(double theta) const noexcept;
  /// p(0), the largest pressure.
  double peak() const noexcept;
  /// S = ∫ p dS/R_n (ball), ∫ p rho dt/P (pin).
  double force_ratio() const noexcept { return force_ratio_; }
  /// a_0, a_1, ...
  std::span<const double> coefficients() const noexcept {
    return {coefficients_.data(), static_cast<std::size_t>(terms_)};
  }

 private:
  double half_angle_;
  double force_ratio_;
  double tangent_;  // b = tan(theta0/2)
  int terms_;
  std::array<double, max_terms> coefficients_{};
};

}  // namespace contact
