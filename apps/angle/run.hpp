#pragma once

#include "angle/setup.hpp"
#include "cli/program.hpp"

namespace hinge_angle {

/// The whole program. Throws contact::Error for options that are wrong.
cli::ExitStatus run(const Options& options);

}  // namespace hinge_angle
