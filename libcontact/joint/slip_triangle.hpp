#pragma once

#include <cmath>

#include "libcontact/base/units.hpp"
#include "libcontact/friction/integrals.hpp"

namespace contact::detail {

/// The right spherical triangle of slip axis, normal force and reaction
/// (unit vectors w, n, e; right angle at n).
///
/// Its sides are b (hypotenuse), g and pi/2 - a; psi is the angle at w. Seen
/// along w the force triangle is that of a pin: R sin b is its hypotenuse,
/// R_t and R_n cos a are its legs, so that
///
///     tan psi = f/cos a,  sin g = sin b sin psi,  cot a = tan b cos psi
///
/// psi runs over [0, pi/2], whatever b. Where g -> b and a -> pi/2, cos psi
/// carries what is left of both; nothing here cancels.
struct SlipTriangle {
  double sin_psi = 0;
  double cos_psi = 1;
  double cos_g = 1;
  SlipAxis axis = {0, 1};  ///< a >= 0

  SlipTriangle() = default;
  /// @param tangent    tan psi, [0, 1e150]
  /// @param reaction   sine and cosine of b, both >= 0
  SlipTriangle(double tangent, SineCosine reaction) {
    // cos^2 g = cos^2 b + sin^2 b cos^2 psi = s^2 cos^2 psi
    const double r = std::sqrt(1 + tangent * tangent);
    const double leg = reaction.cos * tangent;
    const double s = std::sqrt(1 + leg * leg);
    const double inverse = 1 / (r * s);
    const double inverse_s = r * inverse;
    cos_psi = s * inverse;
    sin_psi = tangent * cos_psi;
    cos_g = s * cos_psi;
    axis = {reaction.cos * (r * inverse_s), reaction.sin * inverse_s};
  }
};

}  // namespace contact::detail
