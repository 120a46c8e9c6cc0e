#pragma once

#include "libcontact/friction/kernel/cap_rule.hpp"

/// Rules for pressures that start like a square root (docs/friction.md, "Other
/// pressures"), to some 1e-11, to be had by cap_rule_index(). The first call of
/// each function makes its rules.
namespace contact::detail {

/// What the pressure along an arc has beside a few smooth terms.
enum class ArcTerms {
  smooth,           ///< nothing
  logarithm,        ///< a small logarithm, or terms of a high order
  large_logarithm,  ///< more of both
  high_order,       ///< terms beyond the 16th, to 1e-8: thin liners
};

/// Along an arc the edge cuts: like cap_rule(), for integrands with the factor
/// cos^2 am(u, k), which the weights hold, and, but for smooth pressures,
/// ln cos^2 am(u, k), whose values have corrections.
const CapRules& arc_rules(ArcTerms terms);

/// Like cap_rule(), with fewer nodes: whole circles, and over all circles
/// through a pole in the contact.
/// All integrands along whole circles are smooth.
const CapRules& short_rules(ArcTerms terms);

/// Over circles, for integrands that are even in u but not about the quarter
/// period,
///   integral of G(chi) cos(chi) over [0, pi/2] ~ sum of weight_i G(am(u_i,
///   k)):
/// the circles cut by the edge of a contact with no pole or two. G may have
/// cos^4(chi) ln cos^2(chi).
const CapRules& chord_rules(ArcTerms terms);

/// The same for the whole circles of a contact with two poles, where G behaves
/// like cos^2(chi) ln cos(chi).
const CapRules& whole_chord_rules(ArcTerms terms);

}  // namespace contact::detail
