#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace contact::detail {

/// Nodes and weights of the midpoint rule in the Jacobi variable u,
///   integral of G over [0, pi/2] ~ sum of weight_i G(am(u_i, k)),
/// which converges like exp(-2 pi n K'/K) for the integrands of the exact
/// method: their singularities lie at the height K' above the real axis.
/// Arrays are padded to a multiple of `lanes` with nodes of weight 0.
struct CapRule {
  static constexpr int lanes = 8;
  static constexpr int longest = 152;
  int size;
  int padded_size;
  const double* cosine_squared;  ///< cos^2 am(u_i, k)
  const double* sine_squared;    ///< sin^2 am(u_i, k)
  const double* weight;          ///< K/n dn(u_i, k)
  /// What stands for ln cos^2 am(u_i, k); arc_rules() and chord_rules() only.
  const double* log_cosine_squared;
};

/// One rule serves a range of moduli: k only steers the nodes, the integrand
/// has its own modulus.
inline constexpr int cap_rule_count = 57;
const CapRule& cap_rule(int index);
using CapRules = std::array<CapRule, cap_rule_count>;

/// From the complementary modulus squared k'^2 in [0, 1] to the index of the
/// rule that serves it; any other value, NaN too, gives some rule.
struct CapRuleIndex {
  /// Steps of a quarter of an octave: exponent and two mantissa bits.
  static constexpr int shift = 50;
  static constexpr int steps = 217;
  static constexpr std::int64_t one = std::bit_cast<std::int64_t>(1.0);
  std::array<std::uint8_t, steps> rule_of_step;

  [[gnu::always_inline]] int operator()(double m) const {
    const std::int64_t step = (one - std::bit_cast<std::int64_t>(m)) >> shift;
    return rule_of_step[static_cast<std::size_t>(step < 0        ? 0
                                                 : step >= steps ? steps - 1
                                                                 : step)];
  }
};
const CapRuleIndex& cap_rule_index();

}  // namespace contact::detail
