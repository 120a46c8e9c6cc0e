#pragma once

#include <string>

#include "cli/table.hpp"
#include "separation/results/run.hpp"

namespace separation {

/// Events as a CSV table, time_s, body, what, with all columns in any style. If
/// the case has impacts: also their rates, impulses and losses.
std::string events_csv(const Case& c, const Outcome& outcome,
                       cli::TableStyle style);

}  // namespace separation
