#pragma once

#include <vector>

/// The nodes and weights of friction/kernel/cap_rule.hpp and arc_rule.hpp anew,
/// in 50 digits, by other formulas than tools/friction_rules: sn, cn and dn by
/// Landen's transformation (Abramowitz and Stegun 16.12), corrections of
/// logarithms by digamma functions.
namespace contact::reference {

/// Rounded once.
struct RuleNode {
  double cosine_squared, sine_squared, weight, log_cosine_squared;
};
using RuleNodes = std::vector<RuleNode>;

/// @param index  of the rule in its table
/// @param size   its number of nodes, which only measurement can tell
RuleNodes midpoint_rule(int index, int size);
RuleNodes arc_rule(int index, int size);
RuleNodes chord_rule(int index, int size);
RuleNodes whole_chord_rule(int index, int size);

}  // namespace contact::reference
