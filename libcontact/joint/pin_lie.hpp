// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>

namespace contact {

/// Position of a finite-length pin in its hole, and the forces it needs:
/// docs/how-to/finite_pin.md. Vectors are in the frame of the solution, places
/// along the pin's axis from the middle of the contact, in the direction of the
/// axis that the call gave, or of Dw or M where it gave none.
struct PinLie {
  Eigen::Vector3d tilt = Eigen::Vector3d::Zero();   ///< slope of the pin's axis
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();  ///< shift of the middle, m
  int pieces = 0;  ///< pieces of contact along the pin: 0, 1 or more
  /// Ends of the contact along the pin, m; NaN without contact.
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
  double peak_pressure = std::numeric_limits<double>::quiet_NaN();  ///< Pa
  double peak_place = std::numeric_limits<double>::quiet_NaN();     ///< m
  /// The largest theta0 of all slices, rad, and where it is, m.
  double largest_half_angle = std::numeric_limits<double>::quiet_NaN();
  double half_angle_place = std::numeric_limits<double>::quiet_NaN();
  /// At the ends at -l/2 and l/2: Pa, rad.
  std::array<double, 2> end_pressure = {}, end_half_angle = {};
  /// G = sum of z times the normal force on the hole, N m, and dG/d tilt at a
  /// known shift in the plane of the reaction, N m.
  Eigen::Vector3d tilting_moment = Eigen::Vector3d::Zero();
  double tilting_stiffness = std::numeric_limits<double>::quiet_NaN();
  /// Moment on the body about the middle, N m: across the axis the sum of all,
  /// along it friction.
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  double axial_friction_force = 0;  ///< on the body along the axis, N
};

}  // namespace contact
