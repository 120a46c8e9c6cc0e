#pragma once

#include "libcontact/conforming/exact_results.hpp"
#include "libcontact/pair/inner_loading.hpp"
#include "libcontact/pair/material.hpp"

namespace contact {

/// Exact contact of a pin in a hole whose materials have Dundurs' beta = 0
/// (identical materials among them), loaded at the pin's centre: Persson's
/// closed form. With B = tan^2(theta0/2):
///
///     1/(2 lambda) = (2 - (1+alpha)(ln(1+B) + 2 B^2)) / (4 B (1+B))
///     S = (ln(1+B) + 2 B^2) / (B (1+B))
///
/// Plane strain, no friction, first order in the clearance.
/// Accuracy: largest relative error of load_parameter() 2e-15 up to
/// 1/lambda = 0.1, where its own rounding begins to be magnified by the
/// nearness of the limit angle; half_angle() 4e-16 of itself there; pressure
/// 5e-15 of the peak (conforming/pin_test.cpp, against 50-digit arithmetic).
/// Sources: docs/reference/references.md#persson-1964 for identical materials,
/// docs/reference/references.md#ciavarella-2001 for beta = 0.
class PinClosedForm {
 public:
  /// @param outer_compliance_share  w_2 = (1 + alpha)/2, [0, 1]
  /// @throws Error if out of range.
  explicit PinClosedForm(double outer_compliance_share);

  /// 1/lambda, > 0 below the limit angle, 0 there, < 0 beyond.
  /// @param half_angle  theta0, rad, (0, pi); NaN outside
  double reciprocal_load(double half_angle) const noexcept;

  /// lambda at a half-angle in [0, limit]; infinite at the limit.
  ExactLoad load_parameter(double half_angle) const noexcept;

  /// theta0 at lambda in [0, infinity].
  ExactHalfAngle half_angle(double load_parameter) const noexcept;

  /// theta0*, rad; pi for w_2 = 0 (incompressible pin in a rigid hole).
  double limit_half_angle() const noexcept { return limit_; }

  /// p rho/P at theta for the half-angle theta0 in (0, pi); 0 outside the
  /// contact. It does not depend on alpha.
  static double pressure(double theta, double half_angle) noexcept;

  /// S = ∫ p rho dt/P, 1 at theta0 = 0; it does not depend on alpha.
  static double force_ratio(double half_angle) noexcept;

 private:
  double outer_share_;
  double limit_;
};

}  // namespace contact
