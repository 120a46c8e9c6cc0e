#pragma once

#include <functional>

#include "libcontact/conforming/force_point.hpp"
#include "libcontact/half_angle/table.hpp"
#include "libcontact/pair/inner_loading.hpp"

namespace contact::detail {

/// ContactApproach of an exact contact as Chebyshev series, beside the table
/// of its load. Of two quantities ln h is kept,
///
///     delta/eps, d(delta/eps)/d ln(load) = s^2 (h/(1 - theta0/theta0*) + l),
///
/// s = 2 sin(theta0/2). Both are of order s^2 at any thickness, but for free
/// rings; the stiffness, which follows from the second one, is not. l = 0 for a
/// ball; for a pin, whose displacement has the logarithm of a line load, l =
/// ln(1 + t/(8 s))/2, t the thickness over the radius or 1 if that is less. The
/// variable sqrt(theta0) hides the rest of the logarithm, theta0 ln(theta0),
/// and the ball's logarithm from the series.
class ApproachTable {
 public:
  using Solver = std::function<ForcePoint(double)>;

  /// @param load    of the same contact; kept by reference
  /// @param solver  at theta0 in (0, load.largest()); called here only
  ApproachTable(JointKind kind, const HalfAngleTable& load,
                const Solver& solver);

  /// @param half_angle  (0, largest); NaN outside
  ContactApproach operator()(double half_angle) const noexcept;

 private:
  ChebyshevTable tabulated(int count, const Solver& solver) const;
  double logarithm(double half_angle) const;
  double stiffness(double half_angle, double growth) const;

  JointKind kind_;
  const HalfAngleTable& load_;
  HalfAngleVariable variable_;
  ChebyshevTable series_;  // ln h of the approach and of its growth
};

}  // namespace contact::detail
