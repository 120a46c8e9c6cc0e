#pragma once

#include <Eigen/Core>

#include "libcontact/joint/joint.hpp"

namespace contact::detail {

/// Part of a force that a joint takes: of a pin that normal to its axis.
inline Eigen::Vector3d taken(const Joint& joint, const Eigen::Vector3d& force,
                             const Eigen::Vector3d& angular_velocity,
                             const Eigen::Vector3d& axis) {
  if (!joint.is_pin()) return force;
  const Eigen::Vector3d u =
      axis.isZero(0) ? Eigen::Vector3d(angular_velocity.stableNormalized())
                     : axis;
  return force - force.dot(u) * u;
}

}  // namespace contact::detail
