#pragma once

#include "libcontact/detail/follower_rows.hpp"
#include "libcontact/instruction_set.hpp"

namespace contact::detail {

/// The arithmetic of JointFollower around the evaluation of the contacts,
/// lanes over joints, compiled once per instruction set. `size` joints.
struct FollowerKernel {
  /// Moments from the last evaluations, and all slopes, for R and Dw: the new
  /// place.
  void (*predict)(FollowerRows rows, int size);
  /// Moments for R near the place.
  void (*extend)(FollowerRows rows, int size);
  /// The contacts to be evaluated, for R.
  void (*approach)(FollowerRows rows, int size);
  /// What was found there: slopes learn, moments follow.
  void (*settle)(FollowerRows rows, int size);
};

/// The kernel for a supported instruction set.
const FollowerKernel& follower_kernel(InstructionSet set);

}  // namespace contact::detail
