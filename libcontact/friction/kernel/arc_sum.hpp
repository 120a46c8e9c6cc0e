#pragma once

#include <cmath>

#include "libcontact/base/lanes/logarithm.hpp"
#include "libcontact/base/lanes/select.hpp"
#include "libcontact/friction/kernel/cap_integrals.hpp"

/// The arithmetic of pressures that start like a square root from the edge
/// (docs/internals/other_pressures.md), for V a lane type;
/// instantiated like cap_integrals.hpp. Letters as on that page.
namespace contact::detail {

/// Great circles through the slip axis that a sum runs over.
enum class Circles {
  outside,  ///< arcs cut by the edge, no pole in the contact or both
  inside,   ///< all, one pole in the contact
  whole     ///< arcs within the contact, both poles in it
};

/// A contact and slip axis; CapPoint but for the sign of c.
template <class V>
struct ArcPoint {
  V s, c;   ///< sine and cosine of the half-angle
  V sa, q;  ///< sine and cosine of the slip axis angle, >= 0
  V k, m;   ///< modulus min(z, 1/z) with z = s/q, and 1 - k^2
};

/// A PressureExpansion without its cosine share. C is V or double.
template <int terms, bool with_logarithm, class V, class C>
struct RootPressure {
  V edge_constant;       ///< v
  const C* coefficient;  ///< as many c_k as terms
  const C* logarithmic;  ///< three b_k

  /// p/x
  [[gnu::always_inline]] V over_x(const V& x2, const V& log_X2) const {
    V p = polynomial(x2);
    if constexpr (with_logarithm) {
      p += ((V(logarithmic[2]) * x2 + logarithmic[1]) * x2 + logarithmic[0]) *
           (0.5 * x2 * log_X2);
    }
    return p;
  }

  /// sum c_k B_k: four series side by side.
  [[gnu::always_inline]] V polynomial(const V& x2) const {
    if constexpr (terms == 1) return coefficient[0];
    static_assert(terms == 1 || terms % 4 == 0);
    const V y = 2.0 * x2 - 1.0;
    const V y2 = y * y;
    const V z = y2 * y2 - y2;
    constexpr int last = terms - 4;
    V p0 = coefficient[last];
    V p1 = coefficient[last + 1];
    V p2 = coefficient[last + 2];
    V p3 = coefficient[last + 3];
#pragma GCC unroll 4
    for (int k = last - 4; k >= 0; k -= 4) {
      p0 = p0 * z + coefficient[k];
      p1 = p1 * z + coefficient[k + 1];
      p2 = p2 * z + coefficient[k + 2];
      p3 = p3 * z + coefficient[k + 3];
    }
    return (p3 * y + p2) * y2 + (p1 * y + p0);
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
  V log_top;           ///< ln(X^2/root)
  V force, sliding_cosine, sliding_sine, spinning;
};

/// A node of a rule, as CapRule says.
template <class V>
struct ArcNode {
  V cosine_squared, sine_squared, weight, log_cosine_squared;
};

/// The arc of a node chi. The weight is d chi, but cos(chi) d chi outside and
/// of whole circles, for which cos phi = k' sin chi.
template <Circles circles, bool with_logarithm, class V>
[[gnu::always_inline]] inline Arc<V> arc_of(const ArcPoint<V>& p,
                                            const V& edge_constant,
                                            const ArcNode<V>& node) {
  using std::abs, std::sqrt;
  const V& cos2 = node.cosine_squared;
  const V& sin2 = node.sine_squared;
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
  const V w =
      circles == Circles::inside ? node.weight : V(node.weight * inverse_delta);
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
  if constexpr (with_logarithm) {
    const V top = arc.edge / (1.0 + edge_constant);
    if constexpr (circles == Circles::outside) {
      // The arcs shrink like cos(chi), but for wide contacts.
      const auto wide = p.c < 0.0;
      arc.log_top = logarithm(select(wide, top, V((1.0 + c) * inverse))) +
                    select(wide, V(0.0), node.log_cosine_squared);
    } else {
      arc.log_top = logarithm(top);
    }
  }
  arc.force = arc.spinning * cos2_phi * u;
  arc.sliding_cosine = arc.force * u;
  arc.sliding_sine = arc.spinning * (sa2 * sin2_phi) * (u * u);
  return arc;
}

/// Sums over the nodes.
template <class V>
struct PressureSums {
  V force = 0.0, sliding = 0.0, spinning = 0.0;
};

/// Integrals along an arc: of p/2, p cos(eta)/2, p sin^2(eta)/8.
template <class V>
struct ArcMoments {
  V one = 0.0, cosine = 0.0, sine_squared = 0.0;
};

/// Adds a node in psi; the weights of cut circles hold cos^2(psi).
template <bool whole, int terms, bool with_logarithm, class V, class C>
[[gnu::always_inline]] inline void add_point(
    const Arc<V>& arc,
    const RootPressure<terms, with_logarithm, V, C>& pressure,
    const ArcNode<V>& node, ArcMoments<V>& sum) {
  const V delta2 = arc.constant + arc.cosine * node.cosine_squared;
  const V half = arc.half * node.sine_squared;
  const V& rest = whole ? node.cosine_squared : delta2;  // cos^2(eta/2)
  const V& root = whole ? delta2 : node.cosine_squared;  // factor of x^2
  const V cosine = rest - half;
  const V height = pressure.edge_constant + arc.radius * cosine;
  const V product = height * delta2;
  const V inverse = inverse_roots(product, product).first;
  const V x2 = arc.edge * root * (inverse * inverse * delta2);
  V log_X2 = 0.0;
  if constexpr (with_logarithm) {
    log_X2 = arc.log_top + (whole ? logarithm(root) : node.log_cosine_squared);
  }
  const V weight = whole ? V(node.weight * root) : node.weight;
  const V w = weight * inverse * pressure.over_x(x2, log_X2);
  sum.one += w;
  sum.cosine += w * cosine;
  sum.sine_squared += w * (half * rest);
}

/// Adds an arc to
///   force    2 q     ∫ ∫ p cos^2(phi) cos(eta)/R
///   sliding  2 q     ∫ ∫ p (cos^2(phi) cos^2(eta)
///                           + sa^2 sin^2(phi) sin^2(eta))/R^2
///   spinning 2 sa    ∫ ∫ p sin^2(eta)
template <class V>
[[gnu::always_inline]] inline void add_arc(const Arc<V>& arc,
                                           const ArcMoments<V>& moments,
                                           PressureSums<V>& sum) {
  const V across = 4.0 * moments.sine_squared;
  sum.force += arc.force * moments.cosine;
  sum.sliding +=
      arc.sliding_cosine * (moments.one - across) + arc.sliding_sine * across;
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
