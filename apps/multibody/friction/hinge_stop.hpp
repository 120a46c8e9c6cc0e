// SPDX-License-Identifier: MIT
#pragma once

namespace multibody {

/// A rigid stop of a body on an axis.
///
/// A body that arrives with the rate u leaves with -e u, where e is the
/// restitution. The impulse (1 + e) |u|/w acts through all bodies: w is the
/// response of the rate to a unit impulse about the axis, with all other hinges
/// ideal in that instant, including hinges held by friction. It dissipates (1 -
/// e^2) u^2/(2 w). A moment that never pulls holds a body that rests on its
/// stop; it is a pure couple about the axis, which adds no force to the hinge.
struct HingeStop {
  int body = 0;
  double angle = 0;        ///< rad
  int side = 1;            ///< 1: the body is at larger angles, -1: at smaller
  double restitution = 0;  ///< e, 0 to 1

  /// Distance of the body from the stop, rad.
  double gap(double at) const { return side * (at - angle); }
};

}  // namespace multibody
