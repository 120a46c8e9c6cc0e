#pragma once

#include <Eigen/Core>
#include <vector>

#include "programs/joint/beside.hpp"
#include "programs/joint/input.hpp"
#include "programs/joint/setup.hpp"

namespace hinge_joint {

/// The paper's inner loop under one reaction, step by step.
cli::ExitStatus write_trace(const NamedJoint& joint, const Input& input,
                            const Beside& beside,
                            const cli::OutputOptions& options);

/// A reaction that answers to the friction moment: R = R_0 + M r, with M the
/// friction moment about Dw of all joints (5.1).
struct OuterLaw {
  Eigen::Vector3d slope;  ///< r, N per N m
  double joints = 1;      ///< M is that of so many
  /// Angular acceleration per moment, deg/s^2 per N m; NaN: not wanted.
  double braking;
  /// Steps of the inner loop in each round, the last number for all further
  /// ones; none: until it has converged.
  std::vector<int> inner_steps;
};

/// Throws contact::Error for values that are not allowed.
OuterLaw make_outer_law(const Options& options);

/// The outer loop, a row for each round; with `inner` each step of the inner
/// loops.
cli::ExitStatus write_outer(const NamedJoint& joint, const Input& input,
                            const OuterLaw& law, bool inner,
                            const Beside& beside,
                            const cli::OutputOptions& options);

}  // namespace hinge_joint
