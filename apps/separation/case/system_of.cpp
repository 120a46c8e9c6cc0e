#include "separation/case/system_of.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "separation/case/turn_of_z.hpp"

namespace separation {

using Eigen::Matrix3d;
using Eigen::Vector3d;

multibody::System system_of(const Case& c) {
  std::vector<multibody::Body> bodies;
  for (const Body& body : c.bodies) {
    multibody::Body part;
    part.kind = body.hinge.kind;
    part.mass = body.rigid.mass;
    part.inertia = body.rigid.inertia;
    if (part.kind != multibody::HingeKind::none) {
      part.hinge_from_com = body.hinge.body_point;
      part.hinge_from_carrier_com = body.hinge.carrier_point;
    }
    if (part.kind == multibody::HingeKind::axis) {
      part.hinge_to_carrier_zero = turn_of_z(body.hinge.axis);
      part.hinge_to_body =
          body.hinge.zero_rotation.transpose() * part.hinge_to_carrier_zero;
    }
    bodies.push_back(part);
  }
  return {{c.carrier.mass, c.carrier.inertia, c.carrier.fixed}, bodies};
}

double hinge_angle(const Hinge& hinge, const Matrix3d& rotation) {
  if (hinge.kind == multibody::HingeKind::axis) {
    // rotation = R(axis, t) zero_rotation
    const Matrix3d turn = rotation * hinge.zero_rotation.transpose();
    const double sine = hinge.axis.dot(Vector3d(turn(2, 1) - turn(1, 2),
                                                turn(0, 2) - turn(2, 0),
                                                turn(1, 0) - turn(0, 1)));
    return std::atan2(sine, turn.trace() - 1);
  }
  const Vector3d body = rotation * hinge.body_direction;
  return std::atan2(body.cross(hinge.carrier_direction).norm(),
                    body.dot(hinge.carrier_direction));
}

double hinge_angle(const Hinge& hinge, const multibody::BodyMotion& carrier,
                   const multibody::BodyMotion& body) {
  const double angle =
      hinge_angle(hinge, carrier.rotation.transpose() * body.rotation);
  if (!std::isfinite(body.hinge_angle)) return angle;
  return body.hinge_angle +
         std::remainder(angle - body.hinge_angle, 2 * std::numbers::pi);
}

}  // namespace separation
