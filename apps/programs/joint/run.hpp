#pragma once

#include "cli/program.hpp"
#include "programs/joint/setup.hpp"

namespace hinge_joint {

/// The whole program. Throws contact::Error for options that are wrong.
cli::ExitStatus run(const Options& options);

}  // namespace hinge_joint
