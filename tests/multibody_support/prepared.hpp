#pragma once

#include <vector>

#include "multibody/dynamics/dynamics.hpp"
#include "multibody_support/instant.hpp"

namespace multibody {

/// An instant in link axes, as Dynamics takes it.
struct Prepared {
  System system;
  std::vector<JointMode> modes;
  std::vector<double> state;  ///< StateLayout(system, modes)
  ActiveForces<double> forces;

  /// Dynamics of the system with its joints in their modes.
  Dynamics dynamics() const;
};

/// @throws contact::Error, see System
Prepared prepare(const Instant& instant);

}  // namespace multibody
