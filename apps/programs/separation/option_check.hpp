#pragma once

#include "programs/separation/run.hpp"

namespace separation {

/// Rejects options that conflict or have no effect, as far as the options alone
/// show it.
/// @param format_given  --format is on the command line
/// @throws contact::Error naming the option and the allowed use
void check_options(const Options& options, bool format_given);

}  // namespace separation
