#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace contact::detail {

/// Nodes and weights of the midpoint rule in the Jacobi variable u,
///   integral of G over [0, pi/2] ~ sum of weight_i G(am(u_i, k)),
/// which converges like exp(-2 pi n K'/K) for the integrands of the exact
/// method: their singularities lie at the height K' above the real axis.
/// Arrays are padded to a multiple of `lanes` with nodes of weight 0.
struct CapRule {
  static constexpr int lanes = 8;
  static constexpr int longest = 128;
  int size;
  int padded_size;
  const double* cosine_squared;  ///< cos^2 am(u_i, k)
  const double* sine_squared;    ///< sin^2 am(u_i, k)
  const double* weight;          ///< K/n dn(u_i, k)
  /// Substitute for ln cos^2 am(u_i, k); rules for logarithms only, else 0.
  const double* log_cosine_squared;
};

/// One rule serves a range of moduli: k only steers the nodes, the integrand
/// has its own modulus.
using CapRules = std::span<const CapRule>;
/// Rule i at index i. These rules and the rules of arc_rule.hpp are constants,
/// which the program make-friction-rules (libcontact/tools/friction_rules)
/// writes while the library is built.
extern const CapRules cap_rules;

/// Ends of the ranges of k'^2, from 1 downwards: four steps while few nodes
/// suffice and one more or less counts, then octaves. Below 2^-54 the modulus
/// no longer differs from 1 in double precision.
inline constexpr int cap_rule_count = 57;
inline constexpr auto cap_rule_ends = [] {
  std::array<double, cap_rule_count> ends{0.875, 0.625, 0.5, 0.375, 0.25};
  for (std::size_t i = 5; i < ends.size(); ++i) ends[i] = ends[i - 1] / 2;
  return ends;
}();
static_assert(cap_rule_ends.back() == 0x1p-54);

/// From the complementary modulus squared k'^2 in [0, 1] to the index of the
/// rule that serves it; any other value, NaN too, gives some rule.
class CapRuleIndex {
 public:
  constexpr CapRuleIndex() {
    constexpr std::int64_t step_size = std::int64_t{1} << shift;
    for (int step = 0; step < steps; ++step) {
      // The smallest number of the step.
      const double m = std::bit_cast<double>(one - (step + 1) * step_size + 1);
      std::uint8_t i = 0;
      while (i + 1 < cap_rule_count && m < cap_rule_ends[i]) ++i;
      rule_of_step_[step] = i;
    }
  }

  [[gnu::always_inline]] int operator()(double m) const {
    const std::int64_t step = (one - std::bit_cast<std::int64_t>(m)) >> shift;
    return rule_of_step_[static_cast<std::size_t>(step < 0        ? 0
                                                  : step >= steps ? steps - 1
                                                                  : step)];
  }

 private:
  /// Steps of a quarter of an octave: exponent and two mantissa bits.
  static constexpr int shift = 50;
  static constexpr int steps = 217;
  static constexpr std::int64_t one = std::bit_cast<std::int64_t>(1.0);
  std::array<std::uint8_t, steps> rule_of_step_{};
};
inline constexpr CapRuleIndex cap_rule_index;

}  // namespace contact::detail
