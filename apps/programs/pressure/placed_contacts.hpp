#pragma once

#include "programs/pressure/run.hpp"

namespace hinge_pressure {

/// --direction, --tilt, --load-at: a row for each load and each direction in a
/// seat that ends, or each tilt or place of the load of a pin; with --points
/// its pressure map. Throws contact::Error for options that conflict.
cli::ExitStatus run_placed(const Options& options);

}  // namespace hinge_pressure
