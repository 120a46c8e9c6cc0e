#include "separation/case/system_of.hpp"

#include <cmath>
#include <numbers>

#include "separation/case/hinges/hinge_type.hpp"

namespace separation {

multibody::System system_of(const Case& c) {
  std::vector<multibody::Body> bodies;
  for (const Body& body : c.bodies) {
    multibody::Body part;
    part.kind = body.hinge.kind;
    part.mass = body.rigid.mass;
    part.inertia = body.rigid.inertia;
    part.flows = c.flows(1 + static_cast<int>(bodies.size()));
    if (part.kind != multibody::HingeKind::none) {
      part.hinge_from_com = body.hinge.body_point;
      part.parent = body.hinge.on - 1;
      part.hinge_from_carrier_com = body.hinge.parent_point;
      hinge_type(body.hinge).place(body.hinge, part);
    }
    bodies.push_back(part);
  }
  return {{c.carrier.mass, c.carrier.inertia, c.carrier.fixed, c.flows(0)},
          bodies};
}

double hinge_angle(const Hinge& hinge, const Eigen::Matrix3d& rotation) {
  return hinge_type(hinge).angle(hinge, rotation);
}

double hinge_angle(const Hinge& hinge, const multibody::BodyMotion& parent,
                   const multibody::BodyMotion& body) {
  const double angle =
      hinge_angle(hinge, parent.rotation.transpose() * body.rotation);
  if (!std::isfinite(body.hinge_angle)) return angle;
  return body.hinge_angle +
         std::remainder(angle - body.hinge_angle, 2 * std::numbers::pi);
}

}  // namespace separation
