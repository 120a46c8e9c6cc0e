#pragma once

namespace contact::detail {

/// Nodes and weights of the midpoint rule in the Jacobi variable u,
///   integral of G over [0, pi/2] ~ sum of weight_i G(am(u_i, k)),
/// which converges like exp(-2 pi n K'/K) for the integrands of the exact
/// method: their singularities lie at the height K' above the real axis.
/// Arrays are padded to a multiple of `lanes` with nodes of weight 0.
struct CapRule {
  static constexpr int lanes = 8;
  int size;
  int padded_size;
  const double* cosine;        ///< cos am(u_i, k)
  const double* sine_squared;  ///< sin^2 am(u_i, k)
  const double* weight;        ///< K/n dn(u_i, k)
};

/// Number of rules, and the rule that serves complementary modulus squared
/// k'^2 in [0, 1] (any other value, NaN too, gives some rule). One rule
/// serves a range of moduli: k only steers the nodes, the integrand has its
/// own modulus.
int cap_rule_index(double complementary_modulus_squared);
int cap_rule_count();
const CapRule& cap_rule(int index);

}  // namespace contact::detail
