#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "libcontact/pair/material.hpp"

namespace contact::detail {

/// A sentence for each body that deforms and has another Poisson's ratio than
/// 0.3: "SUBJECT for Poisson's ratio 0.3; the inner body has 0.4". 0.29 and
/// 0.31 pass: they move the limit half-angle by less than 0.9 % (a rigid
/// seat, the worst case).
std::vector<std::string> poisson_notes(std::string_view subject,
                                       const ElasticPair& pair);

}  // namespace contact::detail
