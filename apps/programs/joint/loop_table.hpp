#pragma once

#include "programs/joint/beside.hpp"
#include "programs/joint/input.hpp"
#include "programs/joint/setup.hpp"

namespace hinge_joint {

/// The paper's inner loop under one reaction, step by step.
cli::ExitStatus write_trace(const NamedJoint& joint, const Input& input,
                            const Beside& beside,
                            const cli::OutputOptions& options);

/// The outer loop of Options, a row for each round; with --trace each step of
/// the inner loops.
cli::ExitStatus write_outer(const NamedJoint& joint, const Input& input,
                            const Options& options, const Beside& beside);

}  // namespace hinge_joint
