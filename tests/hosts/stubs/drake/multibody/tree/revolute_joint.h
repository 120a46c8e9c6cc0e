// Declarations of our own of what recipes/drake.cpp uses of Drake.
#pragma once

#include "drake/systems/framework/leaf_system.h"

namespace drake::multibody {

template <class T>
class RevoluteJoint {
 public:
  int ordinal() const;
  int velocity_start() const;
  double get_angular_rate(const systems::Context<T>&) const;
  const Eigen::Vector3d& revolute_axis() const;
};

}  // namespace drake::multibody
