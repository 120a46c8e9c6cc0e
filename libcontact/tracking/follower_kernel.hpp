#pragma once

#include "libcontact/base/instruction_set.hpp"
#include "libcontact/tracking/follower_rows.hpp"

namespace contact::detail {

/// JointFollower::Largest; of moments squares, over 4 M_t^2 + floor. Of the
/// joints followed, infinity for NaN.
struct FollowerLargest {
  double reach, shift, error;
  double miss, moved, answered;
};

/// The arithmetic of JointFollower around the evaluation of the contacts,
/// lanes over joints, compiled once per instruction set. `size` joints.
struct FollowerKernel {
  /// Moments from the last evaluations, and all slopes, for R and Dw: the new
  /// place.
  FollowerLargest (*predict)(FollowerRows rows, int size, double floor);
  /// Moments for R near the place.
  FollowerLargest (*extend)(FollowerRows rows, int size, double floor);
  /// extend(), the contacts to be evaluated, and what windows tell of them.
  /// @return whether a law or integrals of other pressures have to be asked
  bool (*approach)(FollowerRows rows, int size);
  /// What was found there: slopes learn, moments follow.
  FollowerLargest (*settle)(FollowerRows rows, int size, double floor);
  /// What these return, without them.
  FollowerLargest (*largest)(FollowerRows rows, int size, double floor);
  /// JointFollower::act()
  void (*act)(FollowerRows rows, int size);
  /// JointFollower::remember(), extrapolate()
  void (*remember)(FollowerRows rows, int size);
  void (*extrapolate)(FollowerRows rows, int size, double share);
};

/// The kernel for a supported instruction set: lanes that few joints cannot
/// fill cost more than they bring.
const FollowerKernel& follower_kernel(InstructionSet set, int joints);

}  // namespace contact::detail
