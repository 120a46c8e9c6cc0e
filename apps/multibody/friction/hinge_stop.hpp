#pragma once

namespace multibody {

/// A rigid stop of a body on an axis.
///
/// Where the body arrives with the rate u it goes on with -e u, e the
/// restitution. The impulse (1 + e) |u|/w goes through all bodies: w is the
/// response of the rate to a unit impulse about the axis, all other hinges
/// ideal in that instant, those held by friction too; it takes (1 - e^2)
/// u^2/(2 w) of the energy.
/// A body that rests on its stop is held by a moment that never pulls; that
/// is a pure couple about the axis, which adds no force to the hinge.
struct HingeStop {
  int body = 0;
  double angle = 0;        ///< rad
  int side = 1;            ///< 1: the body is at larger angles, -1: at smaller
  double restitution = 0;  ///< e, 0 to 1

  /// How far the body is from it, rad.
  double gap(double at) const { return side * (at - angle); }
};

}  // namespace multibody
