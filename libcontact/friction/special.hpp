#pragma once

#include "libcontact/base/constants.hpp"
#include "libcontact/friction/integrals.hpp"

/// The special cases of the friction integrals of a ball joint with the
/// cosine pressure (3.3), by formulas of their own that do not cancel. With
/// s, c = sin, cos theta0, k^2 the parameter of K, E and
/// B = (E - (1 - k^2) K)/k^2 the cosine part of K
/// (friction/elliptic/integrals.hpp). All results are dimensionless; NaN gives
/// NaN.
namespace contact {

/// Pure sliding, a = 0: no spinning moment; k^2 = 1 - v^2, integrals over
/// c <= v <= 1,
///
///     I[1] = 4 s^2 B(v = c) = 4 (E - c^2 K)     I[p] = 4 ∫ (1 - v^2) B dv
///     J[1] = 4 ∫ E dv                           J[p] = 4 ∫ (v - c) E dv
///
/// Only I[1] is a finite combination of K and E, where the paper (section 3)
/// claims all: J[1] is the slip speed integral, which does not reduce, and
///
///     I[p] = (J[1] - c I[1])/2,
///     J[p] = (4/3)((1 + s^2) E - c^2 K) - c J[1],
///
/// contain it (and cancel for small theta0, so that they only serve the
/// tests).
///
/// @param half_angle  theta0, rad, [0, pi]; NaN outside; chi = sigma_Y = 1 at
///                    theta0 = 0
/// @return relative error at most 3e-15 (friction/special_test.cpp).
FrictionIntegrals sliding_friction_integrals(double half_angle);

/// Pure spinning, a = 90 deg: no force, no sliding moment;
///
///     K[1] = pi (theta0 - s c)          (2 pi/3) theta0^3 as theta0 -> 0
///     K[p] = pi (s - theta0 c - s^3/3)  (2 pi/15) theta0^5
///     sigma_Z = K[p]/I_n                (8/15) theta0, the planar disc's
///
/// @param half_angle  theta0, rad, [0, pi]; NaN outside
/// @return relative error at most 3e-15 (friction/special_test.cpp).
FrictionIntegrals spinning_friction_integrals(double half_angle);

/// Hemisphere, theta0 = 90 deg, any slip axis; k = cos a,
///
///     I[1] = 4 cos a B            I[p] = (pi^2/4) cos a
///     J[1] = (pi^2/2) cos a       J[p] = (4/3) cos a (B + E)
///     K[1] = (pi^2/2) sin a       K[p] = (4/3) sin a E
///
/// so that the area moments equal the moments of a viscous film.
///
/// @param axis  slip axis, sine and cosine of a in [-pi/2, pi/2]
/// @return relative error at most 3e-15 (friction/special_test.cpp).
FrictionIntegrals hemisphere_friction_integrals(SlipAxis axis);

namespace detail {

/// Of arguments out of range.
constexpr FrictionIntegrals all_nan() {
  return {nan, {nan, nan, nan}, {nan, nan, nan}, {nan, nan, nan}};
}

}  // namespace detail

}  // namespace contact
