#pragma once

#include "cli/program.hpp"
#include "programs/joint/setup.hpp"

namespace hinge_joint {

/// Runs the program. Throws contact::Error for wrong options.
cli::ExitStatus run(const Options& options);

}  // namespace hinge_joint
