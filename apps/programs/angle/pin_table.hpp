#pragma once

#include "programs/angle/run.hpp"

namespace hinge_angle {

/// --tilt, --load-at: half-angles and ends of contact of a pin that ends, a row
/// for each load and tilt, or place of the load. Throws contact::Error for
/// options that do not fit together.
cli::ExitStatus run_placed(const Options& options);

}  // namespace hinge_angle
