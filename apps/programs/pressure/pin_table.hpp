#pragma once

#include "programs/pressure/run.hpp"

namespace hinge_pressure {

/// --tilt, --load-at: a row for each load and tilt, or place of the load, of a
/// pin that ends; with --points its map. Throws contact::Error for options that
/// do not fit together.
cli::ExitStatus run_tilted(const Options& options);

}  // namespace hinge_pressure
