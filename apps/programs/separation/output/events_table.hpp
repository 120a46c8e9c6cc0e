#pragma once

#include <string>

#include "cli/table.hpp"
#include "separation/results/run.hpp"

namespace separation {

/// Events as a CSV table: time_s, body, what; all of them in any style.
std::string events_csv(const Outcome& outcome, cli::TableStyle style);

}  // namespace separation
