#pragma once

#include "libcontact/friction/batch.hpp"
#include "libcontact/friction/integrals.hpp"
#include "libcontact/pressure/law.hpp"

namespace contact {

/// Friction integrals and coefficients of a ball joint with any pressure
/// law (docs/friction.md). For CosinePressure they are
/// exact_friction_integrals().
///
/// For the others the same great circles, with a sum over points of each in
/// place of the closed forms: the pressure comes as PressureExpansion, whose
/// square-root edge a change of variable along the circle takes away. No
/// integrand is singular at a pole. For laws without an expansion, those of
/// one's own (ShapedPressure), by parts over the area integrals.
///
/// @param law         of a ball
/// @param half_angle  theta0, rad, [0, law.largest_half_angle()]
/// @param axis        slip axis, sine and cosine of a in [-pi/2, pi/2]
/// @param set         a supported one
/// @return As FrictionIntegrals says, with two differences for laws other than
///         CosinePressure: the weight of `pressure` is p/p(0), that of the
///         contact's centre, so that R_n = rho^2 p(0) normal. Force and
///         sliding even, spinning odd in a.
///         Relative error of each coefficient, given the law's own pressure,
///         at most 1e-10 for theta0 <= 120 deg (friction/any_pressure_test.cpp,
///         against quadrature of the definition and by parts). NaN if an
///         argument is NaN or out of its interval.
/// Neither throws nor allocates.
FrictionIntegrals friction_integrals(
    const PressureLaw& law, double half_angle, SlipAxis axis,
    InstructionSet set = best_instruction_set());

/// friction_integrals() for many points, vectorised over points from 100 points
/// on; input, output, errors and NaN as in exact_friction_integrals() for many
/// points. The same numbers to 4e-11 (friction/any_pressure_test.cpp): the
/// pressure is interpolated between half-angles of the batch, and a point
/// shares the nodes of a neighbour that needs more. Allocates nothing.
void friction_integrals(const PressureLaw& law, const FrictionBatchInput& in,
                        const FrictionBatchOutput& out,
                        InstructionSet set = best_instruction_set());

/// Viscous analogue with any pressure law: traction -k Dv with k = k0 + k1 p,
/// as viscous_friction_integrals() for the cosine pressure. The coefficients
/// belong to k1; with S of PressureLaw::force_ratio() and
/// m = ∬ p sin^2 t dS/R_n:
///
///     chi = cos a,  sigma_Y = (S - m/2) cos a,  sigma_Z = m sin a
///
/// `pressure` and `normal` as in friction_integrals(). Relative error, given
/// the law's own pressure, at most 1e-11 for theta0 <= 120 deg
/// (friction/any_pressure_test.cpp).
FrictionIntegrals viscous_friction_integrals(const PressureLaw& law,
                                             double half_angle, SlipAxis axis);

}  // namespace contact
