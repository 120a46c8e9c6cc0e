#pragma once

#include "programs/joint/setup.hpp"

namespace hinge_joint {

/// --tilt, --load-at: a row for each reaction and tilt, or place of the load,
/// of a pin that ends. Throws contact::Error for options that do not fit
/// together.
cli::ExitStatus run_tilted(const Options& options);

}  // namespace hinge_joint
