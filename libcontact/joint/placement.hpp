// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <limits>

namespace contact {

/// How the halves of a joint whose contact ends lie to each other: where its
/// seat is, or how its pin is tilted in the hole. Vectors are in the frame of
/// the call. A pin that is given one ends, level too; without one it goes on.
struct Placement {
  /// Rotation from the axes of the body with the seat, in which
  /// JointGeometry::seat() gives its axis, to the axes of the vectors.
  Eigen::Matrix3d from_seat = Eigen::Matrix3d::Identity();
  /// Known slope of a pin's axis in its hole, along the direction of the axis
  /// that the call gives (else of Dw or M); what is along the axis is left out.
  Eigen::Vector3d tilt = Eigen::Vector3d::Zero();
  /// Place of the reaction along the pin, m from the middle of the contact: the
  /// tilt is then found. NaN: the tilt is known.
  double place = std::numeric_limits<double>::quiet_NaN();
  /// Speed of the body along a pin's axis, m/s.
  double axial_velocity = 0;

  /// Whether more is asked for than a level pin that turns: of a pin alone.
  bool ends_pin() const {
    return !tilt.isZero(0) || place == place || axial_velocity != 0;
  }
};

}  // namespace contact
