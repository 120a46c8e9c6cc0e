#pragma once

#include <string>

#include "cli/table.hpp"
#include "separation/results/run.hpp"

namespace separation {

/// Events as a CSV table: time_s, body, what; all of them in any style.
/// With the rates, impulses and losses of impacts where the case has such.
std::string events_csv(const Case& c, const Outcome& outcome,
                       cli::TableStyle style);

}  // namespace separation
