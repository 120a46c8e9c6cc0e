#include "libcontact/friction/rules/families.hpp"

#include <algorithm>
#include <cmath>

#include "libcontact/base/gauss_legendre.hpp"
#include "libcontact/friction/kernel/cap_rule.hpp"
#include "libcontact/friction/rules/log_corrections.hpp"

// All sizes were found by measurement (friction/any_pressure_test.cpp).
namespace contact::detail::rules {
namespace {

/// make(modulus) for the first `count` ranges. The rule's k'^2 sits low in its
/// range, so that no integrand of the range has a singularity nearer than K'.
template <class Make>
Rules for_ranges(int count, Make make) {
  Rules rules;
  Real upper = 1;
  for (const Real lower : std::span(cap_rule_ends).first(count)) {
    rules.push_back(make(Modulus(lower + 0.15L * (upper - lower))));
    upper = lower;
  }
  return rules;
}

/// place(i) for a size rounded up.
template <class Place>
Rule nodes(Real size, Place place) {
  Rule rule;
  for (int i = 0; i < size; ++i) rule.push_back(place(i));
  return rule;
}

/// Midpoints of K.
Rules midpoints(Real rate, Real extra) {
  return for_ranges(cap_rule_count, [=](const Modulus& modulus) {
    const Real n = std::ceil(rate * modulus.k / modulus.kc + extra);
    const Real step = modulus.k / n;
    return nodes(n,
                 [&](int i) { return modulus.node(step * (i + 0.5L), step); });
  });
}

/// The integrands vanish at u = K: of an odd number of midpoints of the period
/// 2 K one lies there and counts nothing, so that n nodes do the work of
/// n + 1/2.
Rules arcs(int count, Real extra, Real fewest) {
  return for_ranges(count, [=](const Modulus& modulus) {
    const Real n =
        std::max(std::ceil(5.5L * modulus.k / modulus.kc + extra), fewest);
    const Real steps = n + 0.5L;
    const Real step = modulus.k / steps;
    const auto log = LogCorrections::midpoint(static_cast<int>(n), steps);
    return nodes(n, [&](int i) {
      Node node = modulus.node(step * (i + 0.5L), step);
      node.log_cosine_squared = log.log_square(node.cosine, i);
      node.weight *= node.cosine * node.cosine;
      return node;
    });
  });
}

/// The upper half of a Gauss rule of 2 n nodes.
struct HalfGauss {
  explicit HalfGauss(Real size)
      : n(static_cast<int>(std::ceil(size))), rule(2 * n) {}
  Real x(int i) const { return rule.node(n + i); }
  Real weight(int i) const { return rule.weight(n + i); }
  int n;
  GaussRule<Real> rule;
};

}  // namespace

Rules cap_rules() {
  // At most 3e-16 of error over all contacts and axes.
  return midpoints(8, 0.35L);
}

Rules short_rules() { return midpoints(5.5L, 1); }

Rules smooth_arc_rules() { return arcs(14, 0.5L, 1); }
Rules logarithm_arc_rules() { return arcs(13, 2.5L, 8); }
Rules large_logarithm_arc_rules() { return arcs(13, 3.5L, 9); }

// Gauss' in u on [-K, K], whose ellipse passes through i K', or in sn u on
// [-1, 1], whose ellipse passes through 1/k. Errors fall like exp(-4 n rate).
// At the end cos(am u) is sqrt(1 - x^2) in sn u, but like 1 - x^2 in u: the
// logarithm of cos^5 needs no corrections there.
Rules chord_rules() {
  return for_ranges(cap_rule_count, [](const Modulus& modulus) {
    const Real k = modulus.k;
    const Real rate = std::asinh(modulus.kc / k);
    const Real sine_rate = std::atanh(std::sqrt(modulus.m));
    const HalfGauss gauss(9 / std::max(rate, sine_rate) + 1);
    if (sine_rate < rate) {
      return nodes(gauss.n, [&](int i) {
        Node node = modulus.chord_node(k * gauss.x(i), k * gauss.weight(i));
        node.log_cosine_squared = 2 * std::log(node.cosine);
        return node;
      });
    }
    const auto log = LogCorrections::gauss(gauss.rule);
    return nodes(gauss.n, [&](int i) {
      const Real x = gauss.x(i);
      const Real cosine = std::sqrt((1 - x) * (1 + x));
      return Node{cosine, gauss.weight(i), log.log_square(cosine, i)};
    });
  });
}

// Gauss' in x on [-1, 1] with u = K x (3 - x^2)/2, which takes the edge off
// the logarithm.
Rules whole_chord_rules() {
  return for_ranges(cap_rule_count, [](const Modulus& modulus) {
    const Real k = modulus.k;
    const HalfGauss gauss(7 / std::asinh(modulus.kc / k) + 4);
    return nodes(gauss.n, [&](int i) {
      const Real x = gauss.x(i);
      return modulus.chord_node(k * x * (3 - x * x) / 2,
                                k * gauss.weight(i) * 1.5L * (1 - x) * (1 + x));
    });
  });
}

}  // namespace contact::detail::rules
