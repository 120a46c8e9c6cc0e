#pragma once

#include <Eigen/Core>

namespace separation {

/// Rotation by the shortest turn that takes z to an axis.
/// @param axis  of any length but 0
Eigen::Matrix3d turn_of_z(const Eigen::Vector3d& axis);

}  // namespace separation
