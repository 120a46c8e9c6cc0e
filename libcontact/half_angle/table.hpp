#pragma once

#include <functional>
#include <limits>
#include <optional>

#include "libcontact/base/chebyshev_table.hpp"
#include "libcontact/conforming/half_angle_variable.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/half_angle/law.hpp"
#include "libcontact/half_angle/newton.hpp"

namespace contact::detail {

/// A relation between load and half-angle, known point by point, as one
/// Chebyshev series: the form in which an exact solution is fast.
///
///     F(theta0) = (1 - theta0/theta0*) G(theta0),   G(0) = 1,
///
/// F as in half_angle_newton.hpp. G is smooth: analytic for a pin, with a term
/// theta0^3 ln(theta0) for a ball, which the variable sqrt(theta0) hides from
/// the series. The factors theta0* - theta0 and sin(theta0/2) keep both ends
/// to full relative precision. Const functions without allocation or
/// exceptions.
///
/// A wall changes the relation by orders of magnitude: the series then stores
/// ln G. Its variable: half_angle_variable.hpp.
class HalfAngleTable {
 public:
  /// @param kind         of the joint
  /// @param reciprocal   1/load parameter at theta0 in (0, largest); called
  ///                     here only
  /// @param largest      theta0*, or where the solution ends below it, rad
  /// @param is_limit     whether `largest` is theta0*
  /// @param thickness    t; infinite without walls
  HalfAngleTable(JointKind kind,
                 const std::function<double(double)>& reciprocal,
                 double largest, bool is_limit,
                 double thickness = std::numeric_limits<double>::infinity());

  /// As HalfAngleLaw's; not_converged with largest() for loads beyond the end
  /// of a solution that does not reach its limit.
  HalfAngleResult half_angle(double load_parameter) const noexcept;
  LoadParameterResult load_parameter(double half_angle) const noexcept;

  double largest() const noexcept { return largest_; }
  bool reaches_limit() const noexcept { return is_limit_; }
  double thickness() const noexcept { return variable_.thickness(); }

 private:
  ChebyshevTable tabulated(
      int count, const std::function<double(double)>& reciprocal) const;
  RelationValue evaluate(double half_angle) const noexcept;

  JointKind kind_;
  double largest_;
  bool is_limit_;
  HalfAngleVariable variable_;
  ChebyshevTable series_;  // G or ln G
  std::optional<HalfAngleStart> start_;
};

}  // namespace contact::detail
