#pragma once

#include "libcontact/base/lanes/inverse_root.hpp"
#include "libcontact/friction/kernel/arc_polynomials.hpp"
#include "libcontact/friction/kernel/cap_rule.hpp"

/// The arithmetic of the exact method (docs/internals/exact_method.md),
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
  V k, m;   ///< modulus min(z, 1/z) with z = s/q, and 1 - k^2
};

/// Sums over the nodes, freed of their leading powers of s and q: the
/// integrals follow by assemble(); s = 0 is an ordinary argument.
template <class V>
struct CapSums {
  V force_pressure = 0.0, sliding_pressure = 0.0, spinning_pressure = 0.0;
  V force_area = 0.0, sliding_area = 0.0, spinning_area = 0.0;
};

/// Series for h: by the cosine c of the half-angle, since all arcs have cos d
/// in [c, 1].
enum class ArcRange { small, medium, large };
[[gnu::always_inline]] inline ArcRange arc_range(double c) {
  return c >= arc_h_short.lower    ? ArcRange::small
         : c >= arc_h_medium.lower ? ArcRange::medium
                                   : ArcRange::large;
}

/// Even and odd powers side by side: half the latency of Horner's rule.
template <class V, int n>
[[gnu::always_inline]] inline V evaluate(const ArcPolynomial<n>& p, V x) {
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

/// The sum over nodes for one point, or one point per lane.
///
/// A node is the arc through the pole of the slip axis at the longitude phi;
/// outside sin phi = k sin chi, inside phi = chi. With D = s d, u = 1/R and
/// e = d^2 u^2 (so sin d = s sqrt(e), cos d = c u) every integrand is a
/// product of d, e, u^2 and the one polynomial.
template <bool pole_inside, ArcRange range, class V>
class NodeSum {
 public:
  explicit NodeSum(const CapPoint<V>& p)
      : c_(p.c),
        m_(p.m),
        k2_(p.k * p.k),
        s2_(p.s * p.s),
        r2_constant_(pole_inside ? V(p.sa * p.sa) : V(p.c * p.c)),
        r2_cosine_(pole_inside ? V(p.q * p.q) : s2_),
        sine_factor_(pole_inside ? V(p.sa * p.sa) : V(p.sa * p.sa * k2_)) {}

  /// @param cos2, sin2  of chi;  @param weight  d chi
  [[gnu::always_inline]] void add(V cos2, V sin2, V weight) {
    const V delta2 = m_ + k2_ * cos2;
    const V r2 = r2_constant_ + r2_cosine_ * cos2;
    const auto [u, inverse_delta] = inverse_roots(r2, delta2);
    const V u2 = u * u;
    const V e = u2 * (pole_inside ? delta2 : cos2);
    const V cos2_phi = pole_inside ? cos2 : delta2;
    // d phi times d.
    const V w = (weight * (pole_inside ? delta2 : cos2)) * inverse_delta;
    const V we = w * e;
    V f;   // c f/(d e s^3), but f/(d e s^3) in the large range
    V h;   // R h/(d e s^5), but R h/(d e s^3) in the large range
    V hs;  // R h/(d e s^3)
    V g;   // R g/(d e s^3), g = h + (2/3) sin^3 d
    if constexpr (range == ArcRange::large) {
      // h = (2/3) sin^3 d - f cos d: what cancels here is small beside the
      // nodes with long arcs.
      const V x = c_ * u;
      const V arc = evaluate(arc_f_long, x);
      f = u * arc;
      h = 2.0 / 3 - x * arc;
      hs = h;
    } else {
      if constexpr (range == ArcRange::small) {
        h = e * evaluate(arc_h_short, V(c_ * u));
      } else {
        h = e * evaluate(arc_h_medium, V(c_ * u));
      }
      hs = s2_ * h;
      f = 2.0 / 3 - hs;
    }
    g = 2.0 / 3 + hs;
    const V wf = we * f;
    const V slide = (w * cos2_phi) * u2;
    sum_.force_area += slide;
    sum_.sliding_area += slide * u2;
    sum_.spinning_area += wf;
    sum_.force_pressure += cos2_phi * wf;
    sum_.sliding_pressure +=
        (we * u2) * (cos2_phi * g + (sine_factor_ * sin2) * hs);
    sum_.spinning_pressure += we * h;
  }

  const CapSums<V>& sums() const { return sum_; }

 private:
  V c_, m_, k2_, s2_, r2_constant_, r2_cosine_, sine_factor_;
  CapSums<V> sum_;
};

}  // namespace contact::detail
