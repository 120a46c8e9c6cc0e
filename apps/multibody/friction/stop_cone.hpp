#pragma once

#include <Eigen/Core>

#include "multibody/friction/hinge_stop.hpp"
#include "multibody/system/system.hpp"

namespace multibody {

/// The angle psi of a ball joint's stops, between a direction b of the body and
/// p of its parent: cos psi = p.b. With the relative angular velocity w and n =
/// p x b/sin psi,
///
///     psi' = n.w,
///     psi'' = n.w' + ((w^2 - psi'^2) cos psi - (w.p)(w.b))/sin psi.
///
/// Link axes, as are w and its derivative in Dynamics. At psi = 0 and pi there
/// is no n: everything but gap() is NaN.
class StopCone {
 public:
  /// @param stop  of a body with this link
  StopCone(const HingeStop& stop, const Link& link)
      : body_(link.axes.transpose() * stop.body_direction),
        parent_(stop.parent_direction) {}

  struct Turn {
    Eigen::Vector3d axis;  ///< n
    double rate;           ///< psi', rad/s; within its rounding exactly 0
    double bend;           ///< psi'' - n.w', rad/s^2
  };
  /// @param s  numbers of the body: quaternion and w
  Turn turn(const double* s) const;
  /// side (cos angle - cos psi)/sin angle: distance from a stop in rad, where
  /// it is small. Smooth for all turns, with the rounding of rotations.
  double gap(const HingeStop& stop, const double* s) const;
  /// Turns the body about n until psi is the angle of a stop.
  void put_on(const HingeStop& stop, double* s) const;
  /// Removes psi'.
  void stop_rate(double* s) const;

 private:
  /// p in link axes.
  Eigen::Vector3d parent(const double* s) const;

  Eigen::Vector3d body_;    // b, link axes
  Eigen::Vector3d parent_;  // p, parent axes
};

}  // namespace multibody
