#pragma once

#include "libcontact/friction/kernel/cap_rule.hpp"

/// Rules for pressures that start like a square root
/// (docs/internals/other_pressures.md), to some 1e-11, to be had
/// by cap_rule_index.
namespace contact::detail {

/// Kinds of terms in the pressure along an arc, beside a few smooth ones.
enum class ArcTerms {
  smooth,           ///< nothing
  logarithm,        ///< a small logarithm, or terms of a high order
  large_logarithm,  ///< more of both
  high_order,       ///< terms beyond the 16th, to 1e-8: thin liners
};

/// Along an arc the edge cuts: like cap_rules, for integrands with the factor
/// cos^2 am(u, k), which the weights hold, and, but for smooth pressures, ln
/// cos^2 am(u, k), whose values have corrections. Arcs that all but touch the
/// edge weigh little: the last rule, of k'^2 = 5.6e-4, serves all of a smaller
/// one, and the rule of 1.1e-3 where the logarithm takes more nodes, to 6e-11
/// up to 120 deg.
extern const CapRules smooth_arc_rules;
extern const CapRules logarithm_arc_rules;
extern const CapRules large_logarithm_arc_rules;
extern const CapRules high_order_arc_rules;

/// Like cap_rules, with fewer nodes: whole circles, and over all circles
/// through a pole in the contact.
extern const CapRules short_rules;
extern const CapRules high_order_short_rules;

/// Over circles, for integrands that are even in u but not about the quarter
/// period,
///   integral of G(chi) cos(chi) over [0, pi/2] ~ sum of weight_i G(am(u_i,
///   k)):
/// the circles cut by the edge of a contact with no pole or two. G may have
/// cos^4(chi) ln cos^2(chi).
extern const CapRules chord_rules;
extern const CapRules high_order_chord_rules;

/// The same for the whole circles of a contact with two poles, where G behaves
/// like cos^2(chi) ln cos(chi).
extern const CapRules whole_chord_rules;
extern const CapRules high_order_whole_chord_rules;

inline CapRules arc_rules(ArcTerms terms) {
  switch (terms) {
    case ArcTerms::smooth:
      return smooth_arc_rules;
    case ArcTerms::logarithm:
      return logarithm_arc_rules;
    case ArcTerms::large_logarithm:
      return large_logarithm_arc_rules;
    default:
      return high_order_arc_rules;
  }
}
/// All integrands along whole circles are smooth.
inline CapRules short_rules_of(ArcTerms terms) {
  return terms == ArcTerms::high_order ? high_order_short_rules : short_rules;
}
inline CapRules chord_rules_of(ArcTerms terms) {
  return terms == ArcTerms::high_order ? high_order_chord_rules : chord_rules;
}
inline CapRules whole_chord_rules_of(ArcTerms terms) {
  return terms == ArcTerms::high_order ? high_order_whole_chord_rules
                                       : whole_chord_rules;
}

}  // namespace contact::detail
