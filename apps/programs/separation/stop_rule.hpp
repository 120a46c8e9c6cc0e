#pragma once

#include "cli/interrupts.hpp"
#include "separation/results/run.hpp"

namespace separation {

/// Stops at SIGINT and SIGTERM, after so many steps, and after so many seconds
/// from now.
/// @param interrupts  has to outlive the rule
/// @param steps, seconds  0: without limit
StopRule stop_rule(const cli::Interrupts& interrupts, int steps,
                   double seconds);

}  // namespace separation
