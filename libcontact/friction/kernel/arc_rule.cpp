#include "libcontact/friction/kernel/arc_rule.hpp"

#include <algorithm>
#include <cmath>

#include "libcontact/base/gauss_legendre.hpp"
#include "libcontact/friction/kernel/log_corrections.hpp"
#include "libcontact/friction/kernel/rule_set.hpp"

// All sizes were found by measurement (friction/any_pressure_test.cpp).
namespace contact::detail {
namespace {

using namespace rules;

/// The rules of arc_rules(). The integrands vanish at u = K: of an odd number
/// of midpoints of the period 2 K one lies there and counts nothing, so that n
/// nodes do the work of n + 1/2.
class ArcRules : public RuleSet {
 public:
  ArcRules(Real extra, int fewest) {
    for_ranges([=, this](int index, const Modulus& modulus) {
      const Real k = modulus.k;
      const int n = std::max(node_count(5.5L * k / modulus.kc + extra), fewest);
      const Real steps = n + 0.5L;
      const auto log = LogCorrections::midpoint(n, steps);
      fill(index, n, [&](int i) {
        Node node = modulus.node(k * (i + 0.5L) / steps, k / steps);
        node.log_cosine_squared = log.log_square(node.cosine, i);
        node.weight *= node.cosine * node.cosine;
        return node;
      });
    });
  }
};

/// The rules of short_rules().
class ShortRules : public RuleSet {
 public:
  explicit ShortRules(Real extra) {
    for_ranges([=, this](int index, const Modulus& modulus) {
      const Real k = modulus.k;
      const int n = node_count(5.5L * k / modulus.kc + extra);
      fill(index, n,
           [&](int i) { return modulus.node(k * (i + 0.5L) / n, k / n); });
    });
  }
};

/// A node of the upper half of a Gauss rule.
struct HalfGauss {
  explicit HalfGauss(int size) : n(size), rule(2 * size) {}
  Real x(int i) const { return static_cast<Real>(rule.node(n + i)); }
  Real weight(int i) const { return static_cast<Real>(rule.weight(n + i)); }
  int n;
  GaussLegendre rule;
};

/// The rules of chord_rules(): Gauss' in u on [-K, K], whose ellipse passes
/// through i K', or in sn u on [-1, 1], whose ellipse passes through 1/k.
/// Errors fall like exp(-4 n rate). At the end cos(am u) is sqrt(1 - x^2) in
/// sn u, but like 1 - x^2 in u: the logarithm of cos^5 needs no corrections
/// there.
class ChordRules : public RuleSet {
 public:
  explicit ChordRules(Real extra) {
    for_ranges([=, this](int index, const Modulus& modulus) {
      const Real k = modulus.k;
      const Real rate = std::asinh(modulus.kc / k);
      const Real sine_rate = std::atanh(std::sqrt(modulus.m));
      const HalfGauss gauss(node_count(9 / std::max(rate, sine_rate) + extra));
      if (sine_rate < rate) {
        fill(index, gauss.n, [&](int i) {
          Node node = modulus.chord_node(k * gauss.x(i), k * gauss.weight(i));
          node.log_cosine_squared = 2 * std::log(node.cosine);
          return node;
        });
        return;
      }
      const auto log = LogCorrections::gauss(gauss.rule);
      fill(index, gauss.n, [&](int i) {
        const Real x = gauss.x(i);
        const Real cosine = std::sqrt((1 - x) * (1 + x));
        return Node{x, cosine, gauss.weight(i), log.log_square(cosine, i)};
      });
    });
  }
};

/// The rules of whole_chord_rules(): Gauss' in x on [-1, 1] with
/// u = K x (3 - x^2)/2, which takes the edge off the logarithm.
class WholeChordRules : public RuleSet {
 public:
  explicit WholeChordRules(Real extra) {
    for_ranges([=, this](int index, const Modulus& modulus) {
      const Real k = modulus.k;
      const HalfGauss gauss(node_count(7 / std::asinh(modulus.kc / k) + extra));
      fill(index, gauss.n, [&](int i) {
        const Real x = gauss.x(i);
        return modulus.chord_node(
            k * x * (3 - x * x) / 2,
            k * gauss.weight(i) * 1.5L * (1 - x) * (1 + x));
      });
    });
  }
};

constexpr Real high_order = 10;

template <class Rules>
const CapRules& usual_or_fine(ArcTerms terms, Real extra) {
  if (terms == ArcTerms::high_order) {
    static const Rules fine(extra + high_order);
    return fine.rules();
  }
  static const Rules usual(extra);
  return usual.rules();
}

}  // namespace

const CapRules& arc_rules(ArcTerms terms) {
  switch (terms) {
    case ArcTerms::smooth: {
      static const ArcRules rules(0.5L, 1);
      return rules.rules();
    }
    case ArcTerms::logarithm: {
      static const ArcRules rules(2.5L, 8);
      return rules.rules();
    }
    case ArcTerms::large_logarithm: {
      static const ArcRules rules(3.5L, 9);
      return rules.rules();
    }
    default: {
      static const ArcRules rules(high_order, 17);
      return rules.rules();
    }
  }
}

const CapRules& short_rules(ArcTerms terms) {
  return usual_or_fine<ShortRules>(terms, 1);
}

const CapRules& chord_rules(ArcTerms terms) {
  return usual_or_fine<ChordRules>(terms, 1);
}

const CapRules& whole_chord_rules(ArcTerms terms) {
  return usual_or_fine<WholeChordRules>(terms, 4);
}

}  // namespace contact::detail
