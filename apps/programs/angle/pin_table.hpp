#pragma once

#include "programs/angle/run.hpp"

namespace hinge_angle {

/// --tilt, --load-at: half-angles and contact ends of a finite-length pin, a
/// row for each load and each tilt or place of the load. Throws contact::Error
/// for options that conflict.
cli::ExitStatus run_placed(const Options& options);

}  // namespace hinge_angle
