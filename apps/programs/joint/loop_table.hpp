#pragma once

#include "programs/joint/beside.hpp"
#include "programs/joint/input.hpp"
#include "programs/joint/setup.hpp"

namespace hinge_joint {

/// Writes each step of the paper's inner loop under one reaction.
cli::ExitStatus write_trace(const NamedJoint& joint, const Input& input,
                            const Beside& beside,
                            const cli::OutputOptions& options);

/// Writes a row for each round of the outer loop of Options; with --trace each
/// step of the inner loops.
cli::ExitStatus write_outer(const NamedJoint& joint, const Input& input,
                            const Options& options, const Beside& beside);

}  // namespace hinge_joint
