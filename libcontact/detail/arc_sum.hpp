#pragma once

#include <cmath>

#include "libcontact/detail/cap_integrals.hpp"
#include "libcontact/detail/logarithm.hpp"
#include "libcontact/detail/select.hpp"

/// The arithmetic of pressures that start like a square root from the edge
/// (docs/friction.md, "Other pressures"), for V a lane type; instantiated like
/// cap_integrals.hpp. Letters as on that page.
namespace contact::detail {

/// Which great circles through the slip axis a sum runs over.
enum class Circles {
  outside,  ///< those cut by the edge, no pole in the contact or both
  inside,   ///< all, one pole in the contact
  whole     ///< those within the contact, both poles in it
};

/// A contact and slip axis; CapPoint but for the sign of c.
template <class V>
struct ArcPoint {
  V s, c;   ///< sine and cosine of the half-angle
  V sa, q;  ///< sine and cosine of the slip axis angle, >= 0
  V k, m;   ///< modulus min(z, 1/z) with z = s/q, and 1 - k^2
};

/// A PressureExpansion without its cosine share. C is V or double.
template <class V, class C>
struct RootPressure {
  V edge_constant;       ///< v
  int size;              ///< of the coefficients
  const C* coefficient;  ///< c_k
  const C* logarithmic;  ///< three b_k

  /// p/x
  template <bool with_logarithm>
  [[gnu::always_inline]] V over_x(const V& x2, const V& log_x2) const {
    const V y = 2.0 * x2 - 1.0;
    V p = polynomial(y);
    if constexpr (with_logarithm) {
      p += ((V(logarithmic[2]) * x2 + logarithmic[1]) * x2 + logarithmic[0]) *
           (0.5 * x2 * log_x2);
    }
    return p;
  }

  /// Even and odd powers side by side: half the latency of Horner's rule.
  [[gnu::always_inline]] V polynomial(const V& y) const {
    V first = coefficient[size - 1];
    if (size == 1) return first;
    const V y2 = y * y;
    V second = coefficient[size - 2];
    int k = size - 3;
    for (; k >= 1; k -= 2) {
      first = first * y2 + coefficient[k];
      second = second * y2 + coefficient[k - 1];
    }
    return k == 0 ? V((first * y + second) * y + coefficient[0])
                  : V(first * y + second);
  }
};

/// One great circle or its arc in the contact, eta from the middle:
/// cos theta = R cos eta, sin^2(eta/2) = half sin^2(psi). The four factors
/// hold d phi.
template <class V>
struct Arc {
  V radius;            ///< R
  V constant, cosine;  ///< delta^2 = constant + cosine cos^2(psi)
  V half;              ///< sin^2(d/2), 1 for a whole circle
  V edge;              ///< x^2 (v + R cos eta)/root, root as in add_point()
  V force, sliding_cosine, sliding_sine, spinning;
};

/// The arc of a node chi. The weight is d chi, but cos(chi) d chi outside and
/// of whole circles, for which cos phi = k' sin chi.
template <Circles circles, class V>
[[gnu::always_inline]] inline Arc<V> arc_of(const ArcPoint<V>& p,
                                            const V& edge_constant, V cos2,
                                            V sin2, V weight) {
  using std::abs, std::sqrt;
  const V s2 = p.s * p.s;
  const V sa2 = p.sa * p.sa;
  const V k2 = p.k * p.k;
  const V q2 = p.q * p.q;
  V r2, d2, cos2_phi, sin2_phi;  // d2: D^2/s^2
  if constexpr (circles == Circles::outside) {
    r2 = p.c * p.c + s2 * cos2;
    d2 = cos2;
    cos2_phi = p.m + k2 * cos2;
    sin2_phi = k2 * sin2;
  } else if constexpr (circles == Circles::inside) {
    r2 = sa2 + q2 * cos2;
    d2 = p.m + k2 * cos2;
    cos2_phi = cos2;
    sin2_phi = sin2;
  } else {
    r2 = sa2 + q2 * (p.m * sin2);
    cos2_phi = p.m * sin2;
    sin2_phi = k2 + p.m * cos2;
  }
  const auto [u, inverse_delta] =
      inverse_roots(r2, circles == Circles::whole ? sin2_phi : cos2_phi);
  const V w = circles == Circles::inside ? weight : V(weight * inverse_delta);
  const V r = r2 * u;
  const V c = abs(p.c);
  const V sum = r + c;
  const V inverse = 1.0 / sum;
  const V wide_edge = (1.0 + edge_constant) * sum / (1.0 + c);
  Arc<V> arc;
  arc.radius = r;
  if constexpr (circles == Circles::whole) {
    // (|c| - R)/(|c| + R), 2 R/(|c| + R); c^2 - R^2 = q^2 m cos^2 chi.
    arc.constant = (q2 * p.m * cos2) * (inverse * inverse);
    arc.cosine = 2.0 * r * inverse;
    arc.half = 1.0;
    arc.edge = wide_edge;
    arc.spinning = 4.0 * w * sqrt(arc.edge);
  } else {
    // sin^2(d/2) and cos^2(d/2) for c > 0, the other way round for c < 0:
    // s^2 D^2/(2 R (R + |c|)) and (R + |c|)/(2 R).
    const V share = 0.5 * u * inverse * d2;
    const V small = s2 * share;
    const V large = 0.5 * u * sum;
    const auto wide = p.c < 0.0;
    arc.half = select(wide, large, small);
    arc.constant = select(wide, small, large);
    arc.cosine = arc.half;
    arc.edge = select(wide, wide_edge,
                      V(2.0 * (1.0 + edge_constant) * (1.0 + c) * r * share));
    arc.spinning =
        4.0 * w * sqrt(select(wide, V(large / s2), share) * arc.edge);
  }
  arc.force = arc.spinning * cos2_phi * u;
  arc.sliding_cosine = arc.force * u;
  arc.sliding_sine = arc.spinning * (sa2 * sin2_phi) * (u * u);
  return arc;
}

/// What the sums are of.
template <class V>
struct PressureSums {
  V force = 0.0, sliding = 0.0, spinning = 0.0;
};

/// A node of an inner rule, in psi.
template <class V>
struct ArcNode {
  V cosine_squared, sine_squared, weight, log_cosine_squared;
};

/// Adds a point of an arc to
///   force    2 q     ∫ ∫ p cos^2(phi) cos(eta)/R
///   sliding  2 q     ∫ ∫ p (cos^2(phi) cos^2(eta)
///                           + sa^2 sin^2(phi) sin^2(eta))/R^2
///   spinning 2 sa    ∫ ∫ p sin^2(eta)
template <bool whole, bool with_logarithm, class V, class C>
[[gnu::always_inline]] inline void add_point(const Arc<V>& arc,
                                             const RootPressure<V, C>& pressure,
                                             const ArcNode<V>& node,
                                             PressureSums<V>& sum) {
  const V delta2 = arc.constant + arc.cosine * node.cosine_squared;
  const V half = arc.half * node.sine_squared;
  const V& rest = whole ? node.cosine_squared : delta2;  // cos^2(eta/2)
  const V& root = whole ? delta2 : node.cosine_squared;  // what x^2 vanishes by
  const V cosine = rest - half;
  const V height = pressure.edge_constant + arc.radius * cosine;
  const V product = height * delta2;
  const V inverse = inverse_roots(product, product).first;
  const V x2_over_root = arc.edge * (inverse * inverse * delta2);
  V log_x2 = 0.0;
  if constexpr (with_logarithm) {
    log_x2 = whole ? logarithm(V(x2_over_root * root))
                   : V(node.log_cosine_squared + logarithm(x2_over_root));
  }
  const V p =
      pressure.template over_x<with_logarithm>(x2_over_root * root, log_x2);
  const V w = (node.weight * root) * inverse * p;
  const V across = w * (4.0 * half * rest);
  sum.force += arc.force * (w * cosine);
  sum.sliding += arc.sliding_cosine * (w - across) + arc.sliding_sine * across;
  sum.spinning += arc.spinning * across;
}

/// Puts back what arc_of() left out.
template <Circles circles, class V>
[[gnu::always_inline]] inline PressureSums<V> scaled(
    const ArcPoint<V>& p, const PressureSums<V>& sum) {
  using std::sqrt;
  // d phi has a factor k or k' but inside; sin(d/2) a factor s.
  V along, across;
  if constexpr (circles == Circles::outside) {
    along = 2.0 * p.s * p.s;
    across = 2.0 * p.s * (p.sa * p.k);
  } else if constexpr (circles == Circles::inside) {
    along = 2.0 * p.s * p.q;
    across = 2.0 * p.s * p.sa;
  } else {
    const V kc = sqrt(p.m);
    along = 2.0 * p.q * kc;
    across = 2.0 * p.sa * kc;
  }
  return {along * sum.force, along * sum.sliding, across * sum.spinning};
}

}  // namespace contact::detail
