#pragma once

#include <Eigen/Geometry>

namespace contact::detail {

/// The shortest turn that takes one direction to another one; a half turn about
/// any axis across where they are opposite.
/// @param from, to  of any length but 0
Eigen::Quaterniond turn_between(const Eigen::Vector3d& from,
                                const Eigen::Vector3d& to);

/// The same from z, as a matrix.
Eigen::Matrix3d turn_of_z(const Eigen::Vector3d& to);

}  // namespace contact::detail
