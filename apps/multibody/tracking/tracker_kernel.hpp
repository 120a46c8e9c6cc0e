#pragma once

#include "libcontact/base/instruction_set.hpp"
#include "multibody/tracking/tracker_exchange.hpp"

namespace multibody::detail {

using contact::InstructionSet;

/// All joints of a JointTracker.
struct TrackerJoints {
  int size;
  TrackerExchange* exchange;  ///< blocks of 8 joints
  void* states;  ///< a TrackerState of lanes for TrackerKernel::lanes joints
  double moment_floor;  ///< squared
};

/// The arithmetic of JointTracker around the evaluation of the contacts,
/// lanes over joints, compiled once per instruction set.
struct TrackerKernel {
  int lanes;
  /// @param enough  errors of joints that are left to extend()
  TrackerLargest (*predict)(const TrackerJoints&, double enough);
  TrackerLargest (*extend)(const TrackerJoints&);
  /// extend(), and selects the contacts to evaluate.
  TrackerLargest (*prepare)(const TrackerJoints&);
  /// Corrects slopes and moments by the evaluated values.
  TrackerLargest (*correct)(const TrackerJoints&);
  void (*step)(const TrackerJoints&);
  void (*keep)(const TrackerJoints&);
  void (*extrapolate)(const TrackerJoints&, double share);
};

/// The kernel for a supported instruction set: lanes that few joints cannot
/// fill cost more than they bring.
const TrackerKernel& tracker_kernel(InstructionSet set, int joints);

}  // namespace multibody::detail
