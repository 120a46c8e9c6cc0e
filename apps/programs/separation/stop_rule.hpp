#pragma once

#include "cli/interrupts.hpp"
#include "separation/results/run.hpp"

namespace separation {

/// Stops a run at SIGINT or SIGTERM, after a number of steps, and after a
/// number of seconds from now.
/// @param interrupts  must outlive the rule
/// @param steps, seconds  0: without limit
StopRule stop_rule(const cli::Interrupts& interrupts, int steps,
                   double seconds);

}  // namespace separation
