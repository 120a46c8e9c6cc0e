#pragma once

#include <string>
#include <string_view>

#include "cli/stream/terminal_unit.hpp"
#include "programs/study/findings/findings.hpp"

namespace study {

/// A key or quantity in words: "smallest clearance" for "clearance.smallest_m",
/// "rate at release of booster_*" for "booster_*.at_release.rate_deg_per_s".
std::string shown_name(std::string_view key);

/// As above with the unit: "smallest clearance, m".
std::string shown_label(std::string_view key);

/// "smallest clearance at least 50 mm"
std::string shown_demand(const Requirement& requirement);

/// States a verdict with both of its probabilities: that a run meets the
/// demand, and that so few misses occur by chance.
std::string verdict_sentence(const Study& study, const Requirement& requirement,
                             const Judgement& judgement);

}  // namespace study
