#pragma once

#include <span>

#include "libcontact/base/instruction_set.hpp"
#include "multibody/dynamics/forest_part.hpp"

namespace multibody::detail {

/// Bodies of a forest, for its kernels.
struct ForestBodies {
  std::span<const int> order;  ///< children after parents
  const ForestHinge* hinges;
  ForestPart* parts;
};

/// The two steps for the lanes of one instruction set. `sloped`: some slope is
/// not 0, then nothing is symmetric.
struct ForestKernel {
  /// @param n  of each, rounded up to 4
  void (*sines)(int n, const double* angles, double* sines, double* cosines);
  /// Motions outward, then the matrices inward.
  void (*prepare)(const ForestBodies& bodies, const ForestState* state,
                  bool sloped);
  /// Loads inward: force and moment of the roots are complete after it.
  void (*gather_loads)(const ForestBodies& bodies, const ForestState* state,
                       bool sloped);
  /// Accelerations outward from those of the roots, and the reactions.
  void (*resolve)(const ForestBodies& bodies, bool sloped);
};

/// @param set  a supported one
ForestKernel forest_kernel(contact::InstructionSet set);

}  // namespace multibody::detail
