#pragma once

#include "libcontact/base/instruction_set.hpp"
#include "libcontact/friction/integrals.hpp"

namespace contact {

/// Friction integrals and coefficients of a ball joint with the cosine
/// pressure (3.3), by the exact method: great-circle arcs through the slip
/// axis, every integrand non-negative, a midpoint rule in the Jacobi variable
/// (docs/exact_method.md). Nothing cancels, so each of the ten numbers has its
/// own relative accuracy, the pole on the contact's edge included.
///
/// @param half_angle  theta0, rad, [0, pi]; the limits at theta0 = 0
/// @param axis        slip axis, sine and cosine of a in [-pi/2, pi/2]
/// @param set         a supported one
/// @return all dimensionless; force and sliding even, spinning odd in a.
///         Largest relative error 1.3e-15 on data/reference
///         (friction/exact_test.cpp), theta0 <= 120 deg.
///         NaN if an argument is NaN or theta0 outside its interval.
/// Source: (3.2) to (3.9).
FrictionIntegrals exact_friction_integrals(
    double half_angle, SlipAxis axis,
    InstructionSet set = best_instruction_set());

}  // namespace contact
