#pragma once

#include "programs/pressure/run.hpp"

namespace hinge_pressure {

/// --direction, --tilt, --load-at: a row for each load and direction in a seat
/// that ends, or tilt or place of the load of a pin; with --points its map.
/// Throws contact::Error for options that do not fit together.
cli::ExitStatus run_placed(const Options& options);

}  // namespace hinge_pressure
