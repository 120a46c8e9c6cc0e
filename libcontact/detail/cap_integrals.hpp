#pragma once

#include <cmath>

#include "libcontact/detail/arc_polynomials.hpp"
#include "libcontact/detail/cap_rule.hpp"

/// The arithmetic of the exact method (docs/friction.md, "The exact method"),
/// for a number type V: a lane type or double. Letters as on that page.
///
/// Each translation unit instantiates it with the lane type of its own
/// instruction set only, so that no two of them share a function.
namespace contact::detail {

/// Contact and slip axis, reduced to a half-angle of at most 90 degrees.
template <class V>
struct CapPoint {
  V s, c;   ///< sine and cosine of the half-angle, c >= 0
  V sa, q;  ///< sine and cosine of the slip axis angle, q >= 0
  V k2, m;  ///< modulus squared, min(z, 1/z)^2 with z = s/q, and 1 - k2
};

/// Sums over the nodes, freed of their leading powers of s and q: the
/// integrals are these times scales(); s = 0 is an ordinary argument.
template <class V>
struct CapSums {
  V force_pressure{}, sliding_pressure{}, spinning_pressure{};
  V force_area{}, sliding_area{}, spinning_area{};
};

/// Which series serves h: by the cosine c of the half-angle, since all arcs
/// have cos d in [c, 1].
enum class ArcRange { small, medium, large };
inline constexpr double small_range_cosine = arc_h_short.lower;
inline constexpr double medium_range_cosine = arc_h_medium.lower;

/// Even and odd powers side by side: half the latency of Horner's rule.
template <class V, int n>
V evaluate(const ArcPolynomial<n>& p, V x) {
  const V y = x - p.centre;
  const V y2 = y * y;
  constexpr int top_even = (n - 1) / 2 * 2;
  constexpr int top_odd = (n - 2) / 2 * 2 + 1;
  V even(p.coefficients[top_even]);
  V odd(p.coefficients[top_odd]);
#pragma GCC unroll 16
  for (int i = top_even - 2; i >= 0; i -= 2) {
    even = even * y2 + p.coefficients[i];
  }
#pragma GCC unroll 16
  for (int i = top_odd - 2; i >= 0; i -= 2) {
    odd = odd * y2 + p.coefficients[i];
  }
  return even + y * odd;
}

/// Quantities of the point that the nodes share.
template <ArcRange range, class V>
struct CapConstants {
  explicit CapConstants(const CapPoint<V>& p)
      : k2(p.k2),
        m(p.m),
        s2(p.s * p.s),
        c(p.c),
        c2(p.c * p.c),
        q2(p.q * p.q),
        sa2(p.sa * p.sa),
        inverse(1.0 / (range == ArcRange::large ? s2 : c)) {}
  V k2, m, s2, c, c2, q2, sa2;
  V inverse;  // the only reciprocal the range needs; never of a small number
};

/// Adds one node: arc through the colatitude pole of the slip axis at the
/// longitude phi. Outside: sin phi = k sin chi; inside: phi = chi.
template <bool pole_inside, ArcRange range, class V>
void add_node(const CapConstants<range, V>& p, V cos_chi, V sin2_chi, V weight,
              CapSums<V>& sum) {
  using std::sqrt;
  const V cos2_chi = cos_chi * cos_chi;
  const V delta = sqrt(p.m + p.k2 * cos2_chi);
  const V r2 =
      pole_inside ? V(p.sa2 + p.q2 * cos2_chi) : V(p.c2 + p.s2 * cos2_chi);
  const V r = sqrt(r2);
  // D = s d_over_s; d chi = weight, d phi = w.
  V inverse_r, d_over_s, cos2_phi, sin2_phi, w;
  if constexpr (pole_inside) {
    inverse_r = 1.0 / r;
    d_over_s = delta;
    cos2_phi = cos2_chi;
    sin2_phi = sin2_chi;
    w = weight;
  } else {
    const V inverse = 1.0 / (r * delta);
    inverse_r = inverse * delta;
    d_over_s = cos_chi;
    cos2_phi = delta * delta;
    sin2_phi = p.k2 * sin2_chi;
    w = weight * cos_chi * (inverse * r);
  }
  const V sd = d_over_s * inverse_r;  // sin d / s
  const V cd = p.c * inverse_r;
  const V sd2 = sd * sd;
  const V sd3 = sd2 * sd;
  const V sd3_23 = sd3 * (2.0 / 3.0);
  V f;   // f / s^3
  V hs;  // h / s^3
  V h;   // h / s^5
  if constexpr (range == ArcRange::large) {
    // h = (2/3) sd^3 - cd f: what cancels here is small beside the nodes
    // with long arcs.
    f = sd3 * evaluate(arc_f_long, cd);
    hs = sd3_23 - cd * f;
    h = hs * p.inverse;
  } else {
    if constexpr (range == ArcRange::small) {
      h = sd2 * sd3 * evaluate(arc_h_short, cd);
    } else {
      h = sd2 * sd3 * evaluate(arc_h_medium, cd);
    }
    hs = p.s2 * h;
    f = (sd3_23 - hs) * (r * p.inverse);
  }
  const V slide = cos2_phi * sd * inverse_r;
  sum.force_area += w * slide;
  sum.sliding_area += w * (p.s2 * f + 2.0 * slide * cd * inverse_r);
  sum.spinning_area += w * f;
  sum.force_pressure += w * (cos2_phi * f);
  sum.sliding_pressure +=
      w * inverse_r * (cos2_phi * (hs + sd3_23) + p.sa2 * sin2_phi * hs);
  sum.spinning_pressure += w * (r * h);
}

}  // namespace contact::detail
