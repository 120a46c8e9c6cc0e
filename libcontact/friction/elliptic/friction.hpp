#pragma once

#include "libcontact/friction/integrals.hpp"

namespace contact {

/// Friction integrals and coefficients of a ball joint with the cosine
/// pressure (3.3), by the exact elliptic form: complete elliptic integrals
/// K, E, Pi of the modulus min(z, 1/z), z = sin theta0/cos a, and the slip
/// speed integral (docs/internals/elliptic_form.md).
///
/// The form subtracts numbers of order theta0^2 to leave integrals of order
/// theta0^4 and theta0^6. In double precision it is a check of the exact
/// method (friction/friction_integrals.hpp), which is faster and loses nothing;
/// for other real types include friction/elliptic/friction_real.hpp.
///
/// @param half_angle  theta0, rad, [0, pi]; the limits at theta0 = 0
/// @param axis        slip axis, sine and cosine of a in [-pi/2, pi/2]
/// @return all dimensionless; force and sliding even, spinning odd in a.
///         NaN if an argument is NaN or theta0 outside its interval.
///         Relative error in double, with s = sin theta0 and
///         M = max(s, cos a): area force and sliding 2e-15/M^2; area
///         spinning, pressure force and sliding 6e-15/(s M)^2; pressure
///         spinning 3e-14/(s^2 M)^2 (friction/elliptic_test.cpp): nothing is
///         left of the last below theta0 = 0.02 deg. At 50 digits all 20
///         digits of data/reference, from theta0 = 0.01 deg.
/// Source: (3.2) to (3.9); the form is this library's own.
FrictionIntegrals elliptic_friction_integrals(double half_angle, SlipAxis axis);

/// Slip speed integral A(theta0, a): the integral of |Dw x r|/|Dw| over the
/// contact, the one part of the friction integrals that is not a finite
/// combination of K, E and Pi. It is the potential of the area moments,
///
///     A = J[1] cos a + K[1] sin a,   dA/da = K[1] cos a - J[1] sin a,
///
/// and A rho^2 |Dw| times the shear stress is the friction power of a contact
/// with constant stress. pi^2/2 at theta0 = 90 deg, pi^2 on the whole sphere;
/// pi theta0^2 cos a as theta0 -> 0.
///
/// @param half_angle  theta0, rad, [0, pi]
/// @param axis        slip axis, sine and cosine of a in [-pi/2, pi/2]
/// @return dimensionless, even in a; relative error at most 2e-15
///         (friction/elliptic_test.cpp). NaN as above.
double slip_speed_integral(double half_angle, SlipAxis axis);

}  // namespace contact
