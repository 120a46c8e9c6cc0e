#pragma once

#include "programs/pressure/run.hpp"

namespace hinge_pressure {

/// --direction: a row for each load and direction of it, of a ball in a seat
/// that ends. Throws contact::Error for options that do not fit together.
cli::ExitStatus run_in_seat(const Options& options);

}  // namespace hinge_pressure
