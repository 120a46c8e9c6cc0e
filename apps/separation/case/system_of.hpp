#pragma once

#include "multibody/system/system.hpp"
#include "separation/case/case.hpp"

namespace separation {

/// Carrier and bodies of a case. Body axes are its body axes.
multibody::System system_of(const Case& c);

/// Angle of a body from its rotation relative to its parent: about the axis,
/// (-pi, pi], or between the two directions of a ball hinge, [0, pi].
/// @param rotation  body axes to parent axes
double hinge_angle(const Hinge& hinge, const Eigen::Matrix3d& rotation);

/// Angle of a moving body. On an axis full turns are counted; after its release
/// it is within half a turn of the angle at release.
double hinge_angle(const Hinge& hinge, const multibody::BodyMotion& parent,
                   const multibody::BodyMotion& body);

}  // namespace separation
