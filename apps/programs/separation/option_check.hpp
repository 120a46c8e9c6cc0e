#pragma once

#include "programs/separation/run.hpp"

namespace separation {

/// Options that contradict each other or can have no effect, as far as they
/// alone tell.
/// @param format_given  --format is on the command line
/// @throws contact::Error with the option and what is allowed
void check_options(const Options& options, bool format_given);

}  // namespace separation
