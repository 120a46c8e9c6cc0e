#pragma once

#include "programs/joint/input.hpp"
#include "programs/joint/setup.hpp"

namespace hinge_joint {

/// --equivalent: a line for each number that another program needs, with the
/// largest error over the states. Throws contact::Error unless there is exactly
/// one joint, with dry friction, and all states have friction.
cli::ExitStatus write_equivalent(const Setup& setup, const Inputs& inputs,
                                 const cli::OutputOptions& options);

/// --kernel: writes the load law of the only joint as source text.
cli::ExitStatus write_kernel(const Options& options, const Setup& setup);

}  // namespace hinge_joint
