#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "cli/interrupts.hpp"

namespace separation {

/// Asked before every step of a run with the number of steps so far: why the
/// run has to stop, "" to go on.
using StopRule = std::function<std::string(long steps)>;

/// Stops at SIGINT and SIGTERM, after so many steps, and after so many seconds
/// from now.
/// @param interrupts  has to outlive the rule
/// @param steps, seconds  0: without limit
StopRule stop_rule(const cli::Interrupts& interrupts, int steps,
                   double seconds);

}  // namespace separation
