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

/// A range of moduli as the makers of rules see it.
struct Modulus {
  explicit Modulus(Real complementary_squared)
      : m(complementary_squared),
        am(std::sqrt(m)),
        k(am.quarter_period()),
        kc(Amplitude(std::sqrt(1 - m)).quarter_period()) {}
  Real m;  ///< k'^2
  Amplitude am;
  Real k, kc;  ///< K, K'
};

/// Rules of one kind, one for each range of the modulus, in place.
class RuleSet {
 public:
  const CapRule& rule(int index) const { return rules_[index]; }

 protected:
  /// A node u with the weight du; `chord` multiplies it by cos am(u).
  struct Node {
    Real u, du;
    bool chord;
  };

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
  void fill(int index, int size, const Modulus& modulus, Place place) {
    const int padded =
        (size + CapRule::lanes - 1) / CapRule::lanes * CapRule::lanes;
    assert(padded <= longest);
    const Real m = modulus.m;
    Nodes& nodes = nodes_[index];
    for (int i = 0; i < padded; ++i) {
      const Node node = place(std::min(i, size - 1));
      const Real phi = modulus.am(node.u);
      const Real s = std::sin(phi);
      const Real c = std::cos(phi);
      const Real weight = node.chord ? node.du * c : node.du;
      nodes.cosine_squared[i] = static_cast<double>(c * c);
      nodes.sine_squared[i] = static_cast<double>(s * s);
      nodes.weight[i] =
          i < size
              ? static_cast<double>(weight * std::sqrt(m + (1 - m) * c * c))
              : 0.0;
    }
    rules_[index] = {size, padded, nodes.cosine_squared.data(),
                     nodes.sine_squared.data(), nodes.weight.data()};
  }

 private:
  /// The longest rule has 119 nodes.
  static constexpr int longest = 128;
  struct Nodes {
    std::array<double, longest> cosine_squared, sine_squared, weight;
  };
  std::array<CapRule, cap_rule_count> rules_{};
  std::array<Nodes, cap_rule_count> nodes_{};
};

/// The rules of cap_rule(): not even the first use allocates.
class CapRules : public RuleSet {
 public:
  CapRules() {
    for_ranges([this](int index, const Modulus& modulus) {
      // Found by measurement: at most 3e-16 of error over all contacts and
      // axes.
      const Real k = modulus.k;
      const int n = static_cast<int>(std::ceil(8 * k / modulus.kc + 0.35L));
      fill(index, n, modulus, [k, n](int i) {
        return Node{k * (i + 0.5L) / n, k / n, false};
      });
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

/// The rules of chord_rule(); making them allocates.
class ChordRules : public RuleSet {
 public:
  ChordRules() {
    for_ranges([this](int index, const Modulus& modulus) {
      // The half of a Gauss rule on [-K, K] whose ellipse passes through i K':
      // the error is exp(-4 n asinh(K'/K)), by measurement below 1e-12.
      const Real k = modulus.k;
      const int n =
          static_cast<int>(std::ceil(9 / std::asinh(modulus.kc / k) + 3));
      const GaussLegendre gauss(2 * n);
      fill(index, n, modulus, [k, n, &gauss](int i) {
        return Node{k * static_cast<Real>(gauss.node(n + i)),
                    k * static_cast<Real>(gauss.weight(n + i)), true};
      });
    });
  }
};

const CapRules& cap_rules() {
  static const CapRules instance;
  return instance;
}

const ChordRules& chord_rules() {
  static const ChordRules instance;
  return instance;
}

}  // namespace

const CapRule& cap_rule(int index) { return cap_rules().rule(index); }
const CapRule& chord_rule(int index) { return chord_rules().rule(index); }
const CapRuleIndex& cap_rule_index() { return cap_rules().index(); }

}  // namespace contact::detail
