#include "libcontact/tools/friction_rules/families.hpp"

#include <algorithm>
#include <span>

#include "libcontact/base/gauss_legendre.hpp"
#include "libcontact/friction/kernel/cap_rule.hpp"
#include "libcontact/tools/friction_rules/log_corrections.hpp"

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
    rules.push_back(make(Modulus(lower + 3 * (upper - lower) / 20)));
    upper = lower;
  }
  return rules;
}

/// The number of nodes that a rate of convergence asks for.
int node_count(const Real& count) { return static_cast<int>(ceil(count)); }

/// place(i) for all nodes.
template <class Place>
Rule nodes(int size, Place place) {
  Rule rule;
  for (int i = 0; i < size; ++i) rule.push_back(place(i));
  return rule;
}

/// Midpoints of K.
Rules midpoints(double rate, double extra) {
  return for_ranges(cap_rule_count, [=](const Modulus& modulus) {
    const int n = node_count(rate * modulus.k / modulus.kc + extra);
    const Real step = modulus.k / n;
    return nodes(n,
                 [&](int i) { return modulus.node(step * (i + 0.5), step); });
  });
}

/// The integrands vanish at u = K: of an odd number of midpoints of the period
/// 2 K one lies there and counts nothing, so that n nodes do the work of
/// n + 1/2.
Rules arcs(int count, double extra, int fewest) {
  return for_ranges(count, [=](const Modulus& modulus) {
    const int n =
        std::max(node_count(5.5 * modulus.k / modulus.kc + extra), fewest);
    const Real step = modulus.k / (n + 0.5);
    const auto corrections = midpoint_log_corrections(n);
    return nodes(n, [&](int i) {
      Node node = modulus.node(step * (i + 0.5), step);
      node.log_cosine_squared = 2 * log(node.cosine) + corrections[i];
      node.weight *= node.cosine * node.cosine;
      return node;
    });
  });
}

/// The upper half of the Gauss rule of 2 n nodes.
struct HalfGauss {
  explicit HalfGauss(int n) {
    const GaussLegendre rule(2 * n);
    for (int i = n; i < 2 * n; ++i) {
      // One of Newton's steps takes doubles to 30 digits.
      const Real start = rule.node(i);
      Real previous = 1;
      Real value = start;
      for (int j = 2; j <= 2 * n; ++j) {
        previous = ((2 * j - 1) * start * value - (j - 1) * previous) / j;
        swap(previous, value);
      }
      const Real rest = (1 - start) * (1 + start);
      const Real slope = 2 * n * (previous - start * value) / rest;
      const Real step = -value / slope;
      x.push_back(start + step);
      // (1 - x^2) P'^2 has the slope 2 x P'^2 at a zero of P.
      weight.push_back(2 / (slope * slope * (rest + 2 * start * step)));
    }
  }
  std::vector<Real> x, weight;
};

// Gauss' in u on [-K, K], whose ellipse passes through i K', or in sn u on
// [-1, 1], whose ellipse passes through 1/k. Errors fall like exp(-4 n rate).
// At the end cos(am u) is sqrt(1 - x^2) in sn u, but like 1 - x^2 in u: the
// logarithm of cos^5 needs no corrections there.
Rules chords(double extra) {
  return for_ranges(cap_rule_count, [=](const Modulus& modulus) {
    const Real k = modulus.k;
    const Real rate = asinh(Real(modulus.kc / k));
    const Real sine_rate = atanh(sqrt(modulus.m));
    const int n = node_count(9 / std::max(rate, sine_rate) + extra);
    const HalfGauss gauss(n);
    if (sine_rate < rate) {
      return nodes(n, [&](int i) {
        Node node = modulus.chord_node(k * gauss.x[i], k * gauss.weight[i]);
        node.log_cosine_squared = 2 * log(node.cosine);
        return node;
      });
    }
    const auto corrections = gauss_log_corrections(gauss.x, gauss.weight);
    return nodes(n, [&](int i) {
      const Real square = 1 - gauss.x[i] * gauss.x[i];
      return Node{sqrt(square), gauss.weight[i], log(square) + corrections[i]};
    });
  });
}

// Gauss' in x on [-1, 1] with u = K x (3 - x^2)/2, which takes the edge off
// the logarithm.
Rules whole_chords(double extra) {
  return for_ranges(cap_rule_count, [=](const Modulus& modulus) {
    const Real k = modulus.k;
    const int n = node_count(7 / asinh(Real(modulus.kc / k)) + extra);
    const HalfGauss gauss(n);
    return nodes(n, [&](int i) {
      const Real& x = gauss.x[i];
      return modulus.chord_node(k * x * (3 - x * x) / 2,
                                k * gauss.weight[i] * 3 * (1 - x * x) / 2);
    });
  });
}

// Nodes more for pressures with terms beyond the 16th.
constexpr double high_order = 10;

}  // namespace

// At most 3e-16 of error over all contacts and axes.
Rules cap_rules() { return midpoints(8, 0.35); }
Rules short_rules() { return midpoints(5.5, 1); }
Rules high_order_short_rules() { return midpoints(5.5, 1 + high_order); }

Rules smooth_arc_rules() { return arcs(14, 0.5, 1); }
Rules logarithm_arc_rules() { return arcs(13, 2.5, 8); }
Rules large_logarithm_arc_rules() { return arcs(13, 3.5, 9); }
Rules high_order_arc_rules() { return arcs(13, high_order, 17); }

Rules chord_rules() { return chords(1); }
Rules high_order_chord_rules() { return chords(1 + high_order); }
Rules whole_chord_rules() { return whole_chords(4); }
Rules high_order_whole_chord_rules() { return whole_chords(4 + high_order); }

}  // namespace contact::detail::rules
