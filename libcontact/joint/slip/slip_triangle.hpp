#pragma once

#include "libcontact/base/lanes/inverse_root.hpp"

namespace contact::detail {

/// The right spherical triangle of slip axis, normal force and reaction
/// (unit vectors w, n, e; right angle at n).
///
/// Its sides are b (hypotenuse), g and pi/2 - a; psi is the angle at w. Seen
/// along w the forces form a pin's triangle: R sin b is its hypotenuse, R_t and
/// R_n cos a are its legs, so that
///
///     tan psi = f/cos a,  sin g = sin b sin psi,  cot a = tan b cos psi
///
/// psi runs over [0, pi/2], whatever b. Where g -> b and a -> pi/2, cos psi
/// carries what is left of both; nothing here cancels.
///
/// For doubles, and for lanes over joints.
template <class T>
struct SlipTriangle {
  T tangent;  ///< tan psi
  T sin_psi, cos_psi, cos_g;
  T axis_sin, axis_cos;  ///< sin a, cos a; a >= 0

  /// @param tan_psi        [0, 1e150]
  /// @param sin_b, cos_b   both >= 0
  [[gnu::always_inline]] void set(const T& tan_psi, const T& sin_b,
                                  const T& cos_b) {
    // cos^2 g = cos^2 b + sin^2 b cos^2 psi = s^2 cos^2 psi
    tangent = tan_psi;
    const T leg = cos_b * tangent;
    const T r2 = 1.0 + tangent * tangent;
    const T s2 = 1.0 + leg * leg;
    const auto [inverse_r, inverse_s] = inverse_roots(r2, s2);
    cos_psi = inverse_r;
    sin_psi = tangent * cos_psi;
    cos_g = root(s2, inverse_s) * cos_psi;
    axis_sin = cos_b * (root(r2, inverse_r) * inverse_s);
    axis_cos = sin_b * inverse_s;
  }
  /// By which ln R_n and half of ln cos^2 a fall as ln tan psi grows.
  struct Response {
    T force, cosine;
  };
  [[gnu::always_inline]] Response response() const {
    const T sin2_psi = sin_psi * sin_psi;
    return {sin2_psi * axis_cos * axis_cos, sin2_psi * axis_sin * axis_sin};
  }
  /// A step in ln tan psi, by differentials: wrong by its square.
  [[gnu::always_inline]] void shift(const T& step) {
    const Response fall = response();
    tangent *= 1.0 + step;
    const T sin2_psi = sin_psi * sin_psi;
    sin_psi *= 1.0 + cos_psi * cos_psi * step;
    cos_psi *= 1.0 - sin2_psi * step;
    cos_g *= 1.0 - fall.force * step;
    axis_sin *= 1.0 + fall.force * step;
    axis_cos *= 1.0 - fall.cosine * step;
  }
};

}  // namespace contact::detail
