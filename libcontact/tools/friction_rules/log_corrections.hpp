#pragma once

#include <vector>

#include "libcontact/tools/friction_rules/modulus.hpp"

/// For integrands f + g ln T, f and g smooth, g ~ T^2, T = 0 at the end behind
/// the last node: what to add to ln T at the nodes so that a rule has T^2 ln T,
/// T^3 ln T, ... exactly, as many as it corrects nodes. The higher powers are
/// smooth enough for any rule.
namespace contact::detail::rules {

/// Midpoints (i + 1/2) (pi/2)/(n + 1/2), i < n, T = cos^2.
std::vector<Real> midpoint_log_corrections(int n);
/// The upper half of a Gauss rule, T = 1 - x^2.
std::vector<Real> gauss_log_corrections(const std::vector<Real>& x,
                                        const std::vector<Real>& weight);

}  // namespace contact::detail::rules
