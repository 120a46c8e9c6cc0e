#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "libcontact/friction/kernel/cap_rule.hpp"

/// What the makers of rules over moduli share.
namespace contact::detail::rules {

using Real = long double;

/// Ranges of k'^2 from 1 downwards: four steps while few nodes suffice and
/// one more or less counts, then octaves. Below 2^-54 the modulus no longer
/// differs from 1 in double precision.
inline constexpr int octaves = 54;
inline constexpr std::array<Real, cap_rule_count> lower_bounds = [] {
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
  const CapRules& rules() const { return rules_; }

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
  CapRules rules_{};
  std::array<Nodes, cap_rule_count> nodes_{};
};

/// The number of nodes that a rate of convergence asks for.
inline int node_count(Real count) {
  return std::min(static_cast<int>(std::ceil(count)), CapRule::longest);
}

}  // namespace contact::detail::rules
