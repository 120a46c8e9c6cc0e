// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace multibody {

/// A rigid stop of a body on an axis or on a ball joint. On a ball joint it
/// limits the angle psi, 0 to pi, between a direction of the body and one of
/// its parent: a cone. The rate of psi is the relative angular velocity about
/// the axis n that is normal to both directions.
///
/// A body that arrives with the rate u leaves with -e u, where e is the
/// restitution. The impulse (1 + e) |u|/w about the axis acts through all
/// bodies: w is the response of the rate to a unit impulse, with all other
/// hinges ideal in that instant, including hinges held by friction; a ball
/// joint turns freely about the axes normal to n. Bodies that rest on their
/// stops and would be driven into them stay there, by impulses of these stops
/// that are part of w. It dissipates (1 - e^2) u^2/(2 w).
///
/// A moment that never pulls holds a body that rests on its stop; it is a pure
/// couple about the axis, which adds no force to the hinge. A ball joint goes
/// on turning along the cone, psi'' = 0, until its friction holds it. Then the
/// stop takes the part of the held moment with which the impending slip of the
/// joint is along the cone, as its motion is when it gives way; or nothing, if
/// it would slide off the stop.
struct HingeStop {
  int body = 0;
  double angle = 0;        ///< rad; on a ball joint between 0 and pi
  int side = 1;            ///< 1: the body is at larger angles, -1: at smaller
  double restitution = 0;  ///< e, 0 to 1
  /// Ball joint only: unit vectors, body axes and parent axes.
  Eigen::Vector3d body_direction = Eigen::Vector3d::Zero();
  Eigen::Vector3d parent_direction = Eigen::Vector3d::Zero();

  /// Distance of the body from the stop, rad.
  double gap(double at) const { return side * (at - angle); }
};

/// How near an angle between directions is known, rad: a body that starts so
/// near to a stop of its ball joint starts at it.
inline constexpr double cone_rounding = 1e-12;

}  // namespace multibody
