#pragma once

#include "programs/duty/options.hpp"

namespace hinge_duty {

/// Runs the program. Throws contact::Error for wrong options.
cli::ExitStatus run(const Options& options);

}  // namespace hinge_duty
