// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "libcontact/base/units.hpp"

/// Friction integrals of a ball joint (theory: docs/explanation/friction.md).
///
/// Axes: origin at the joint's centre, Z through the centre of the contact,
/// the relative angular velocity in the plane OYZ at the slip axis angle a
/// from Y: a = 0 is pure sliding, a = 90 deg pure spinning. The contact is
/// the cap 0 <= theta <= theta0 of the unit sphere.
namespace contact {

/// Direction of the relative angular velocity, as sine and cosine of the slip
/// axis angle a in [-pi/2, pi/2] (cos >= 0, sin^2 + cos^2 = 1).
///
/// A joint knows both from its vectors: sin a = w.n, cos a = |w x n|. Close to
/// 90 deg an angle in double precision has lost the digits that matter, so
/// the kernels take the pair.
struct SlipAxis {
  double sin;
  double cos;

  /// @param a  slip axis angle, rad, [-pi/2, pi/2]
  static SlipAxis from_angle(double a) { return {std::sin(a), std::cos(a)}; }
  /// @param b  complement pi/2 - a of the slip axis angle, rad, [0, pi]:
  ///           the angle between the relative angular velocity and the normal
  static SlipAxis from_complement(double b) {
    return {std::cos(b), std::sin(b)};
  }
  /// @param a_deg  slip axis angle, degrees, [-90, 90]; exact at 0 and 90
  static SlipAxis from_degrees(double a_deg) {
    const SineCosine a = detail::sine_cosine_deg(a_deg);
    return {a.sin, a.cos};
  }
};

/// One quantity for each of the three roles: the friction force (the paper's
/// I, chi), the sliding moment about Y (J, sigma_Y) and the spinning moment
/// about Z (K, sigma_Z).
template <class Real>
struct BasicFrictionTriple {
  Real force;
  Real sliding;
  Real spinning;
};
using FrictionTriple = BasicFrictionTriple<double>;

/// Friction integrals of one contact and slip axis, by any method; everything
/// is dimensionless. In double, except where a method is offered at higher
/// precision.
template <class Real>
struct BasicFrictionIntegrals {
  /// I_n, integral of the pressure shape's normal component, (3.2), (3.4).
  Real normal;
  /// I, J, K with weight cos(theta) - cos(theta0) (superscript 0 in (3.9)).
  BasicFrictionTriple<Real> pressure;
  /// I, J, K with weight 1 (the primed integrals of (3.7), (3.8)).
  BasicFrictionTriple<Real> area;
  /// chi, sigma_Y, sigma_Z = pressure / normal, (3.9), with their limits at
  /// theta0 = 0: 0 for sigma_Z; 1 for the others, or 0 if a = +-90 deg.
  BasicFrictionTriple<Real> coefficient;
};
using FrictionIntegrals = BasicFrictionIntegrals<double>;

}  // namespace contact
