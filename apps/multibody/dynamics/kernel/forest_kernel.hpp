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

/// The two steps for the lanes of one instruction set. `sloped`: a slope is not
/// 0, so that matrices are not symmetric.
struct ForestKernel {
  /// @param n  of each, rounded up to 4
  void (*sines)(int n, const double* angles, double* sines, double* cosines);
  /// Motions outward, then the matrices inward.
  void (*prepare)(const ForestBodies& bodies, const ForestState* state,
                  bool sloped);
  /// Loads inward; completes force and moment of the roots.
  void (*gather_loads)(const ForestBodies& bodies, const ForestState* state,
                       bool sloped);
  /// Accelerations outward from the roots, and the reactions.
  void (*resolve)(const ForestBodies& bodies, bool sloped);
};

/// @param set  a supported one
ForestKernel forest_kernel(contact::InstructionSet set);

}  // namespace multibody::detail
