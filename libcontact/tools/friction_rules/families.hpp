#pragma once

#include <vector>

#include "libcontact/tools/friction_rules/modulus.hpp"

/// The rules of kernel/cap_rule.hpp and kernel/arc_rule.hpp, by the names they
/// have there, one for each range of the modulus.
namespace contact::detail::rules {

using Rules = std::vector<Rule>;
Rules cap_rules();
Rules smooth_arc_rules();
Rules logarithm_arc_rules();
Rules large_logarithm_arc_rules();
Rules high_order_arc_rules();
Rules short_rules();
Rules high_order_short_rules();
Rules chord_rules();
Rules high_order_chord_rules();
Rules whole_chord_rules();
Rules high_order_whole_chord_rules();

}  // namespace contact::detail::rules
