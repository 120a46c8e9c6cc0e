#pragma once

#include <array>
#include <functional>

#include "libcontact/half_angle.hpp"

namespace contact::detail {

/// A relation between load and half-angle, known point by point, as one
/// Chebyshev series: the form in which an exact solution is fast.
///
/// With power = 2 (pin) or 3 (ball) and x the variable of the half-angle laws,
///
///     F(theta0) = (2 sin(theta0/2)/x)^power = (1 - theta0/theta0*) G(theta0)
///
/// falls from 1 at theta0 = 0 to 0 at the limit half-angle theta0*. G is
/// smooth: analytic for a pin, with a term theta0^3 ln(theta0) for a ball,
/// which the variable sqrt(theta0) hides from the series. The factors
/// theta0* - theta0 and sin(theta0/2) keep both ends to full relative
/// precision. Const functions without allocation or exceptions.
class HalfAngleTable {
 public:
  /// @param kind         of the joint
  /// @param reciprocal   1/load parameter at theta0 in (0, largest); called
  ///                     here only
  /// @param largest      theta0*, or where the solution ends below it, rad
  /// @param is_limit     whether `largest` is theta0*
  HalfAngleTable(JointKind kind,
                 const std::function<double(double)>& reciprocal,
                 double largest, bool is_limit);

  /// As HalfAngleLaw's; not_converged with largest() for loads beyond the end
  /// of a solution that does not reach its limit.
  HalfAngleResult half_angle(double load_parameter) const noexcept;
  LoadParameterResult load_parameter(double half_angle) const noexcept;

  double largest() const noexcept { return largest_; }
  bool reaches_limit() const noexcept { return is_limit_; }

 private:
  struct Value {
    double value;  // F
    double slope;  // dF/dtheta0
  };
  Value evaluate(double half_angle) const noexcept;
  double start(double x) const noexcept;

  static constexpr int max_terms = 64;

  JointKind kind_;
  int terms_;
  double largest_;
  bool is_limit_;
  std::array<double, max_terms> coefficients_{};  // of G
};

}  // namespace contact::detail
