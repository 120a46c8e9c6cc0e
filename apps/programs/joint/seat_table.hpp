#pragma once

#include "programs/joint/setup.hpp"

namespace hinge_joint {

/// --in-seat: a row for each reaction of a ball in a seat that ends. Throws
/// contact::Error for options that do not fit together.
cli::ExitStatus run_in_seat(const Options& options);

}  // namespace hinge_joint
