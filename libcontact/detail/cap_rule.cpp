#include "libcontact/detail/cap_rule.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "libcontact/detail/gauss_legendre.hpp"

namespace contact::detail {
namespace {

using Real = long double;

/// Ranges of k'^2 from 1 downwards: four steps while few nodes suffice and
/// one more or less counts, then octaves. Below 2^-54 the modulus no longer
/// differs from 1 in double precision.
constexpr int octaves = 54;
constexpr std::array<Real, cap_rule_count> lower_bounds = [] {
  std::array<Real, cap_rule_count> bounds{0.875L, 0.625L, 0.5L, 0.375L, 0.25L};
  for (std::size_t i = 5; i < bounds.size(); ++i) bounds[i] = bounds[i - 1] / 2;
  return bounds;
}();
static_assert(lower_bounds.back() == 1 / Real(1LL << octaves));

/// Amplitude am(u, k) by the descending Landen transformation on the
/// arithmetic-geometric mean (Abramowitz and Stegun 16.4, 17.6).
class Amplitude {
 public:
  explicit Amplitude(Real complementary_modulus) {
    Real b = complementary_modulus;
    a_[0] = 1;
    c_[0] = std::sqrt((1 - b) * (1 + b));
    while (steps_ + 1 < a_.size() && c_[steps_] > 1e-19L * a_[steps_]) {
      const Real a = a_[steps_];
      ++steps_;
      a_[steps_] = (a + b) / 2;
      c_[steps_] = (a - b) / 2;
      b = std::sqrt(a * b);
    }
  }
  Real quarter_period() const {
    return std::numbers::pi_v<Real> / 2 / a_[steps_];
  }
  Real operator()(Real u) const {
    Real phi = std::ldexp(a_[steps_] * u, static_cast<int>(steps_));
    for (std::size_t i = steps_; i > 0; --i) {
      phi = (phi + std::asin(c_[i] / a_[i] * std::sin(phi))) / 2;
    }
    return phi;
  }

 private:
  std::size_t steps_ = 0;
  std::array<Real, 24> a_{};
  std::array<Real, 24> c_{};
};

/// A node as the makers of rules place it.
struct Node {
  Real sine, cosine, weight;
  Real log_cosine_squared = 0;
};

/// A range of moduli as the makers of rules see it.
struct Modulus {
  explicit Modulus(Real complementary_squared)
      : m(complementary_squared),
        am(std::sqrt(m)),
        k(am.quarter_period()),
        kc(Amplitude(std::sqrt(1 - m)).quarter_period()) {}

  /// At u, with the weight dn(u) du.
  Node node(Real u, Real du) const {
    const Real phi = am(u);
    const Real c = std::cos(phi);
    return {std::sin(phi), c, du * std::sqrt(m + (1 - m) * c * c)};
  }
  /// The same times cos(phi).
  Node chord_node(Real u, Real du) const {
    Node result = node(u, du);
    result.weight *= result.cosine;
    return result;
  }

  Real m;  ///< k'^2
  Amplitude am;
  Real k, kc;  ///< K, K'
};

/// Rules of one kind, one for each range of the modulus, in place.
class RuleSet {
 public:
  const CapRule& rule(int index) const { return rules_[index]; }

 protected:
  /// make(i, modulus) for every rule. The rule's k'^2 sits low in its range,
  /// so that no integrand of the range has a singularity nearer than K'.
  template <class Make>
  static void for_ranges(Make make) {
    Real upper = 1;
    for (int i = 0; i < cap_rule_count; ++i) {
      const Real lower = lower_bounds[i];
      make(i, Modulus(lower + 0.15L * (upper - lower)));
      upper = lower;
    }
  }

  /// place(i) is the Node i of `size`; the padding repeats the last one, with
  /// weight 0.
  template <class Place>
  void fill(int index, int size, Place place) {
    const int padded =
        (size + CapRule::lanes - 1) / CapRule::lanes * CapRule::lanes;
    assert(padded <= CapRule::longest);
    Nodes& nodes = nodes_[index];
    for (int i = 0; i < padded; ++i) {
      const Node node = place(std::min(i, size - 1));
      nodes.cosine_squared[i] = static_cast<double>(node.cosine * node.cosine);
      nodes.sine_squared[i] = static_cast<double>(node.sine * node.sine);
      nodes.weight[i] = i < size ? static_cast<double>(node.weight) : 0.0;
      nodes.log_cosine_squared[i] =
          static_cast<double>(node.log_cosine_squared);
    }
    rules_[index] = {size,
                     padded,
                     nodes.cosine_squared.data(),
                     nodes.sine_squared.data(),
                     nodes.weight.data(),
                     nodes.log_cosine_squared.data()};
  }

 private:
  struct Nodes {
    std::array<double, CapRule::longest> cosine_squared, sine_squared, weight,
        log_cosine_squared;
  };
  std::array<CapRule, cap_rule_count> rules_{};
  std::array<Nodes, cap_rule_count> nodes_{};
};

/// The number of nodes that a rate of convergence asks for.
int node_count(Real count) {
  return std::min(static_cast<int>(std::ceil(count)), CapRule::longest);
}

/// The rules of cap_rule(): not even the first use allocates.
class CapRules : public RuleSet {
 public:
  CapRules() {
    for_ranges([this](int index, const Modulus& modulus) {
      // Found by measurement: at most 3e-16 of error over all contacts and
      // axes.
      const Real k = modulus.k;
      const int n = node_count(8 * k / modulus.kc + 0.35L);
      fill(index, n,
           [&](int i) { return modulus.node(k * (i + 0.5L) / n, k / n); });
    });
    fill_index();
  }
  const CapRuleIndex& index() const { return index_; }

 private:
  void fill_index() {
    constexpr std::int64_t width = std::int64_t{1} << CapRuleIndex::shift;
    for (int step = 0; step < CapRuleIndex::steps; ++step) {
      // The smallest number of the step.
      const double m =
          std::bit_cast<double>(CapRuleIndex::one - (step + 1) * width + 1);
      std::size_t i = 0;
      while (i + 1 < lower_bounds.size() && m < lower_bounds[i]) ++i;
      index_.rule_of_step[step] = static_cast<std::uint8_t>(i);
    }
  }

  CapRuleIndex index_{};
};

/// ln cos^2 am(u_i, k) of a midpoint rule, its Fourier series in
/// theta = pi u/(2 K) cut off: ln(cos^2 am/cos^2 theta) is smooth, and
/// ln cos^2 theta = -2 ln 2 - 2 sum (-1)^j cos(2 j theta)/j.
Real resolved_log_cosine_squared(int i, int n, Real cosine) {
  const Real theta = std::numbers::pi_v<Real> / 2 * (i + 0.5L) / n;
  Real series = -2 * std::numbers::ln2_v<Real>;
  for (int j = 1; j < n; ++j) {
    series -= (j % 2 == 0 ? 2 : -2) * std::cos(2 * j * theta) / j;
  }
  return series + 2 * std::log(cosine / std::cos(theta));
}

/// The rules of short_rule() and inside_rule().
class ShortRules : public RuleSet {
 public:
  explicit ShortRules(int extra) {
    for_ranges([this, extra](int index, const Modulus& modulus) {
      const Real k = modulus.k;
      const int n = node_count(5.5L * k / modulus.kc + 1 + extra);
      fill(index, n, [&](int i) {
        Node node = modulus.node(k * (i + 0.5L) / n, k / n);
        node.log_cosine_squared =
            resolved_log_cosine_squared(i, n, node.cosine);
        return node;
      });
    });
  }
};

/// The rules of chord_rule(); making them allocates.
class ChordRules : public RuleSet {
 public:
  ChordRules() {
    for_ranges([this](int index, const Modulus& modulus) {
      // The half of a Gauss rule in u on [-K, K], whose ellipse passes through
      // i K', or in sn u on [-1, 1], whose ellipse passes through 1/k. Errors
      // fall like exp(-4 n rate), by measurement to 1e-11.
      const Real rate = std::asinh(modulus.kc / modulus.k);
      const Real sine_rate = std::atanh(std::sqrt(modulus.m));
      const int n = node_count(9 / std::max(rate, sine_rate) + 1);
      const GaussLegendre gauss(2 * n);
      fill(index, n, [&](int i) {
        const Real x = static_cast<Real>(gauss.node(n + i));
        const Real w = static_cast<Real>(gauss.weight(n + i));
        if (sine_rate < rate) {
          return modulus.chord_node(modulus.k * x, modulus.k * w);
        }
        return Node{x, std::sqrt((1 - x) * (1 + x)), w};
      });
    });
  }
};

/// The rules of log_chord_rule(); making them allocates.
class LogChordRules : public RuleSet {
 public:
  LogChordRules() {
    for_ranges([this](int index, const Modulus& modulus) {
      // The half of a Gauss rule in x on [-1, 1] with u = K x (3 - x^2)/2,
      // which takes the edge off the logarithm. The size by measurement.
      const Real k = modulus.k;
      const int n = node_count(11 / std::asinh(modulus.kc / k) + 5);
      const GaussLegendre gauss(2 * n);
      fill(index, n, [&](int i) {
        const Real x = static_cast<Real>(gauss.node(n + i));
        const Real w = static_cast<Real>(gauss.weight(n + i));
        return modulus.chord_node(k * x * (3 - x * x) / 2,
                                  k * w * 1.5L * (1 - x) * (1 + x));
      });
    });
  }
};

/// The rules of small_log_chord_rule(); making them allocates.
class SmallLogChordRules : public RuleSet {
 public:
  SmallLogChordRules() {
    for_ranges([this](int index, const Modulus& modulus) {
      // The half of a Gauss rule in u on [-K, K], with nodes enough for the
      // logarithm: its error falls as a power of n. The size by measurement.
      const Real k = modulus.k;
      const int n = node_count(9 / std::asinh(modulus.kc / k) + 4);
      const GaussLegendre gauss(2 * n);
      fill(index, n, [&](int i) {
        return modulus.chord_node(k * static_cast<Real>(gauss.node(n + i)),
                                  k * static_cast<Real>(gauss.weight(n + i)));
      });
    });
  }
};

/// The rule of gauss_arc_rule(); making it allocates.
class GaussArcRule : public RuleSet {
 public:
  GaussArcRule() {
    // 12 nodes by measurement: 5e-11 where the logarithms are largest.
    constexpr int n = 12;
    const GaussLegendre gauss(2 * n);
    const Real quarter = std::numbers::pi_v<Real> / 2;
    fill(0, n, [&](int i) {
      const Real psi = quarter * static_cast<Real>(gauss.node(n + i));
      const Real cosine = std::cos(psi);
      return Node{std::sin(psi), cosine,
                  quarter * static_cast<Real>(gauss.weight(n + i)),
                  2 * std::log(cosine)};
    });
  }
};

const CapRules& cap_rules() {
  static const CapRules rules;
  return rules;
}

}  // namespace

const CapRule& cap_rule(int index) { return cap_rules().rule(index); }
const CapRuleIndex& cap_rule_index() { return cap_rules().index(); }

const CapRule& short_rule(int index) {
  static const ShortRules rules(0);
  return rules.rule(index);
}

const CapRule& inside_rule(int index) {
  static const ShortRules rules(2);
  return rules.rule(index);
}

const CapRule& gauss_arc_rule(int) {
  static const GaussArcRule rule;
  return rule.rule(0);
}

const CapRule& chord_rule(int index) {
  static const ChordRules rules;
  return rules.rule(index);
}

const CapRule& log_chord_rule(int index) {
  static const LogChordRules rules;
  return rules.rule(index);
}

const CapRule& small_log_chord_rule(int index) {
  static const SmallLogChordRules rules;
  return rules.rule(index);
}

}  // namespace contact::detail
