#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/lanes/select.hpp"
#include "libcontact/base/lanes/sine_cosine.hpp"
#include "libcontact/friction/kernel/cap_integrals.hpp"

/// Steps of the exact method before and after its sum over nodes, for V a lane
/// type or double.
namespace contact::detail {

/// A contact and slip axis with the branches it takes.
template <class V>
struct PreparedCap {
  CapPoint<V> point;
  mask_of<V> pole_inside;
  mask_of<V> beyond_hemisphere;  ///< theta0 above 90 degrees: reflected
};

/// By sine and cosine of the half-angle.
template <class V>
[[gnu::always_inline]] inline PreparedCap<V> prepare(
    const SineCosinePair<V>& half_angle, V axis_sin, V axis_cos) {
  using std::abs;
  const auto& [s, cosine] = half_angle;
  const V c = abs(cosine);
  const V sa = abs(axis_sin);
  const V q = axis_cos;
  // q^2 - s^2 = (q - s)(q + s) = (c - sa)(c + sa), without cancellation by
  // the smaller pair of legs.
  const auto near_corner = c < 0.7 && sa < 0.7;
  const V difference = select(near_corner, V(c - sa), V(q - s));
  const V sum = select(near_corner, V(c + sa), V(q + s));
  const auto inside = difference <= 0.0;
  const V larger = select(inside, s, q);
  // A contact of no size seen along its own normal has z = 0/0: take z = 0.
  const auto empty = larger == 0.0;
  const V inverse = 1.0 / select(empty, V(1.0), larger);
  const V k = select(inside, q, s) * inverse;
  const V m =
      select(empty, V(1.0), V(abs(difference * inverse) * (sum * inverse)));
  return {{s, c, axis_sin, q, k, m}, inside, cosine < 0.0};
}

template <class V>
PreparedCap<V> prepare(V half_angle, V axis_sin, V axis_cos) {
  // NaN compares false: outside [0, pi] everything becomes NaN.
  const V theta0 =
      select(half_angle >= 0.0 && half_angle <= std::numbers::pi, half_angle,
             V(std::numeric_limits<double>::quiet_NaN()));
  return prepare(sine_cosine(theta0), axis_sin, axis_cos);
}

/// The ten numbers of FrictionIntegrals, in its order.
template <class V>
struct CapResult {
  V normal;
  V force_pressure, sliding_pressure, spinning_pressure;
  V force_area, sliding_area, spinning_area;
  V force, sliding, spinning;
};

/// Puts back the powers of s, q and c that NodeSum left out; reflects
/// half-angles above 90 degrees.
template <class V>
CapResult<V> assemble(const PreparedCap<V>& cap, const CapSums<V>& sum) {
  const CapPoint<V>& p = cap.point;
  const V s2 = p.s * p.s;
  const V s4 = s2 * s2;
  // Factors of f and h that the arc ranges left out.
  const auto large = p.c < arc_h_medium.lower;
  const V reciprocal = 1.0 / select(large, s2, p.c);
  const V f_factor = select(large, V(1.0), reciprocal);
  const V h_factor = select(large, reciprocal, V(1.0));
  // The powers of q and sin a that survive: q/s inside, where phi runs to
  // pi/2; outside it runs to asin(z), which brings another factor z = k.
  const V along = 2.0 * select(cap.pole_inside, p.k, V(1.0));
  const V across = 2.0 * p.s * select(cap.pole_inside, p.sa, V(p.sa * p.k));
  // I_n = s^4 normal, (3.2), by (1 - c)^2 = s^4/(1 + c)^2.
  const V one_plus_c = 1.0 + p.c;
  const V normal = pi / 3 * (2.0 + p.c);
  const V opened = one_plus_c * one_plus_c;
  CapResult<V> r;
  const V f_area = f_factor * sum.spinning_area;
  r.force = along * (f_factor * sum.force_pressure);
  r.sliding = along * sum.sliding_pressure;
  r.spinning = across * (h_factor * sum.spinning_pressure);
  r.force_area = 2.0 * along * s2 * sum.force_area;
  r.sliding_area = along * s2 * (s2 * f_area + 2.0 * p.c * sum.sliding_area);
  r.spinning_area = across * s2 * f_area;
  r.force_pressure = s4 * r.force;
  r.sliding_pressure = s4 * r.sliding;
  r.spinning_pressure = s4 * r.spinning;
  V inverse = opened / normal;
  r.normal = s4 * normal / opened;
  if (any(cap.beyond_hemisphere)) {
    // The cap is the whole sphere less the opposite cap.
    constexpr double pi2 = pi * pi;
    const auto beyond = cap.beyond_hemisphere;
    const V pc = pi2 * p.c;
    r.normal = select(beyond, V(pi / 3 * opened * (2.0 - p.c)), r.normal);
    r.sliding_area =
        select(beyond, V(pi2 * p.q - r.sliding_area), r.sliding_area);
    r.spinning_area =
        select(beyond, V(pi2 * p.sa - r.spinning_area), r.spinning_area);
    r.force_pressure =
        select(beyond, V(pi2 / 2 * p.q - r.force_pressure), r.force_pressure);
    r.sliding_pressure =
        select(beyond, V(pc * p.q + r.sliding_pressure), r.sliding_pressure);
    r.spinning_pressure =
        select(beyond, V(pc * p.sa + r.spinning_pressure), r.spinning_pressure);
    r.force = select(beyond, r.force_pressure, r.force);
    r.sliding = select(beyond, r.sliding_pressure, r.sliding);
    r.spinning = select(beyond, r.spinning_pressure, r.spinning);
    inverse = select(beyond, V(1.0 / r.normal), inverse);
  }
  r.force *= inverse;
  r.sliding *= inverse;
  r.spinning *= inverse;
  return r;
}

}  // namespace contact::detail
