#pragma once

#include <Eigen/Core>

namespace contact {

/// The place of the seat of a joint whose contact ends.
struct Placement {
  /// Rotation from the axes of the body that has the seat, in which
  /// JointGeometry::seat() gives its axis, to those of the vectors.
  Eigen::Matrix3d from_seat = Eigen::Matrix3d::Identity();
};

}  // namespace contact
