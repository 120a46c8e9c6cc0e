#include "separation/case/system_of.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "separation/case/turn_of_z.hpp"

namespace separation {

using Eigen::Matrix3d;
using Eigen::Vector3d;

multibody::System system_of(const Case& c) {
  std::vector<multibody::Load> loads;
  for (const Load& load : c.loads) {
    multibody::Load part;
    part.kind = load.hinge.kind;
    part.mass = load.body.mass;
    part.inertia = load.body.inertia;
    if (part.kind != multibody::JointKind::none) {
      part.hinge_from_com = load.hinge.load_point;
      part.hinge_from_carrier_com = load.hinge.carrier_point;
    }
    if (part.kind == multibody::JointKind::axis) {
      part.hinge_to_carrier_zero = turn_of_z(load.hinge.axis);
      part.hinge_to_load =
          load.hinge.zero_rotation.transpose() * part.hinge_to_carrier_zero;
    }
    loads.push_back(part);
  }
  return {{c.carrier.mass, c.carrier.inertia}, loads};
}

double hinge_angle(const Hinge& hinge, const Matrix3d& rotation) {
  if (hinge.kind == multibody::JointKind::axis) {
    // rotation = R(axis, t) zero_rotation
    const Matrix3d turn = rotation * hinge.zero_rotation.transpose();
    const double sine = hinge.axis.dot(Vector3d(turn(2, 1) - turn(1, 2),
                                                turn(0, 2) - turn(2, 0),
                                                turn(1, 0) - turn(0, 1)));
    return std::atan2(sine, turn.trace() - 1);
  }
  const Vector3d load = rotation * hinge.load_direction;
  return std::atan2(load.cross(hinge.carrier_direction).norm(),
                    load.dot(hinge.carrier_direction));
}

double hinge_angle(const Hinge& hinge, const multibody::BodyMotion& carrier,
                   const multibody::BodyMotion& load) {
  const double angle =
      hinge_angle(hinge, carrier.rotation.transpose() * load.rotation);
  if (!std::isfinite(load.hinge_angle)) return angle;
  return load.hinge_angle +
         std::remainder(angle - load.hinge_angle, 2 * std::numbers::pi);
}

}  // namespace separation
