// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "libcontact/friction/integrals.hpp"

namespace contact {

class PressureLaw;

/// Friction integrals and coefficients of a ball joint
/// (docs/explanation/friction.md) with any pressure law.
///
/// For the cosine pressure by the exact method: great-circle arcs through the
/// slip axis, every integrand non-negative, a midpoint rule in the Jacobi
/// variable (docs/internals/exact_method.md). Nothing cancels, so each of the
/// ten numbers has its own relative accuracy, the pole on the contact's edge
/// included.
///
/// For the others the same great circles, with a sum over points of each in
/// place of the closed forms: the pressure comes as PressureExpansion, whose
/// square-root edge a change of variable along the circle takes away. No
/// integrand is singular at a pole. Laws without an expansion, such as
/// user-defined ones (ShapedPressure), are integrated by parts over the area
/// integrals.
///
/// @param law         of a ball
/// @param half_angle  theta0, rad, [0, law.largest_half_angle()]; the limits at
///                    theta0 = 0
/// @param axis        slip axis, sine and cosine of a in [-pi/2, pi/2]
/// @return As FrictionIntegrals says, with two differences for laws other than
///         the cosine pressure: the weight of `pressure` is p/p(0), relative to
///         the contact's centre, so that R_n = rho^2 p(0) normal. Force and
///         sliding even, spinning odd in a.
///         Relative error of each coefficient, given the law's own pressure,
///         at most 1e-10 for theta0 <= 120 deg (friction/any_pressure_test.cpp,
///         against quadrature of the definition and by parts), with the cosine
///         pressure of each number at most 1.3e-15 on data/reference
///         (friction/exact_test.cpp). NaN if an argument is NaN or out of its
///         interval.
/// Neither throws nor allocates.
/// Source: (3.2) to (3.9).
FrictionIntegrals friction_integrals(const PressureLaw& law, double half_angle,
                                     SlipAxis axis);

/// The same with the pressure of the paper, the cosine pressure (3.3).
/// @param half_angle  theta0, rad, [0, pi]
FrictionIntegrals friction_integrals(double half_angle, SlipAxis axis);

/// Arguments of many points, structure of arrays of equal length; meaning,
/// units and intervals as in friction_integrals() of one point.
struct FrictionBatchInput {
  std::span<const double> half_angle;
  std::span<const double> axis_sin;
  std::span<const double> axis_cos;
};

/// Results, each as long as the input or empty where it is not wanted;
/// meaning as in FrictionIntegrals.
struct FrictionBatchOutput {
  std::span<double> normal;
  std::span<double> force_pressure, sliding_pressure, spinning_pressure;
  std::span<double> force_area, sliding_area, spinning_area;
  std::span<double> force, sliding, spinning;
};

/// friction_integrals() for many points, vectorised over points: with laws
/// other than the cosine pressure from 100 points on. NaN and out-of-range
/// arguments give NaN in their own places. Works in blocks with its scratch
/// memory on the stack; allocates nothing.
///
/// Equal to single points to 4e-11 (friction/any_pressure_test.cpp): the
/// pressure is interpolated between half-angles of the batch, and a point
/// shares the nodes of a neighbour that needs more. With the cosine pressure to
/// rounding, largest relative error 1.7e-15 on data/reference
/// (friction/batch_test.cpp).
///
/// @param out  results; must not overlap the arguments
/// @throws Error if lengths differ.
void friction_integrals(const PressureLaw& law, const FrictionBatchInput& in,
                        const FrictionBatchOutput& out);

/// The same with the cosine pressure.
void friction_integrals(const FrictionBatchInput& in,
                        const FrictionBatchOutput& out);

}  // namespace contact
