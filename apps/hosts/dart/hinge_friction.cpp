#include "hosts/dart/hinge_friction.hpp"

namespace contact_hosts::dart {

using ::dart::dynamics::BallJoint;
using ::dart::dynamics::Joint;
using ::dart::dynamics::RevoluteJoint;
using Eigen::Vector3d;

void HingeFriction::add(Joint* joint, const std::string& file) {
  const bool is_ball = joint->getType() == BallJoint::getStaticType();
  if (!is_ball && joint->getType() != RevoluteJoint::getStaticType()) {
    throw std::runtime_error(
        "HingeFriction::add: joint must be a ball or revolute joint");
  }
  hinges_.push_back(
      {joint,
       FrictionMoment(read_dry_joint(file, "HingeFriction::add",
                                     is_ball ? CONTACT_BALL : CONTACT_PIN)),
       0});
}

// Rotates from the axes of the half with the seat to the joint's axes on the
// child.
Eigen::Matrix<double, 3, 3, Eigen::RowMajor> HingeFriction::from_seat(
    const Hinge& h) {
  const auto& child = *h.joint->getChildBodyNode();
  Eigen::Matrix3d axes =
      h.joint->getTransformFromChildBodyNode().linear().transpose();
  if (h.contact.seat() != Seat::on_carrier) return axes;
  axes *= child.getWorldTransform().linear().transpose();
  const auto* const parent = h.joint->getParentBodyNode();
  if (parent) axes *= parent->getWorldTransform().linear();
  return axes;
}

// Vectors are in the joint's axes on the child.
void HingeFriction::update() {
  for (Hinge& h : hinges_) {
    const Eigen::Matrix3d to_joint =
        h.joint->getTransformFromChildBodyNode().linear().transpose();
    const Vector3d reaction =
        to_joint * h.joint->getChildBodyNode()->getBodyForce().tail<3>();
    contact_slip slip{};
    Vector3d::Map(slip.reaction) = reaction;
    const bool is_ball = h.joint->getNumDofs() == 3;
    Vector3d rate = Vector3d::UnitX();  // any, where there is none
    if (!is_ball) {
      rate = static_cast<const RevoluteJoint*>(h.joint)->getAxis();
      Vector3d::Map(slip.axis) = rate;
    } else if (h.joint->getVelocities().norm() > 0) {
      rate = h.joint->getVelocities();
    }
    Vector3d::Map(slip.angular_velocity) = rate;
    Vector3d moment;
    h.contact.find(slip, from_seat(h).data(), moment.data());
    h.limit = moment.norm();
    if (!is_ball) {
      h.joint->setCoulombFriction(0, h.limit);
    } else {
      rub(h, moment);
    }
  }
}

// Friction of a ball: M_t while it slides, and a limit for each axis if a step
// would stop it.
void HingeFriction::rub(Hinge& h, const Vector3d& moment) {
  const auto* const body = h.joint->getChildBodyNode();
  const double arm =
      (h.joint->getTransformFromChildBodyNode().inverse() * body->getLocalCOM())
          .norm();
  const double inertia =
      body->getInertia().getMoment().trace() + body->getMass() * arm * arm;
  const bool stops = h.joint->getVelocities().norm() * inertia <=
                     2 * h.limit * h.joint->getSkeleton()->getTimeStep();
  for (int i = 0; i < 3; ++i) {
    h.joint->setCoulombFriction(i, stops ? h.limit : 0);
    if (!stops) h.joint->setForce(i, h.joint->getForce(i) + moment[i]);
  }
}

}  // namespace contact_hosts::dart
