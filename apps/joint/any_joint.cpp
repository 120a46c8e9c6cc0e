#include "joint/any_joint.hpp"

#include <Eigen/Geometry>

namespace hinge_joint {
namespace {

using contact::BallJoint;
using contact::JointSolution;
using contact::PinJoint;
using Eigen::Vector3d;

Vector3d axis_of(const Vector3d& turn, const Vector3d& force) {
  if (!turn.isZero(0)) return turn.stableNormalized();
  return force.isZero(0) ? Vector3d(Vector3d::UnitZ()) : force.unitOrthogonal();
}

std::variant<BallJoint, PinJoint> make(const contact::JointContact& contact) {
  if (contact.geometry().kind() == contact::JointKind::ball) {
    return BallJoint(contact);
  }
  return PinJoint(contact);
}

contact::RestSolution pin_utilisation(const PinJoint& joint,
                                      const Vector3d& reaction,
                                      const Vector3d& moment) {
  const Vector3d u = -axis_of(moment, reaction);
  contact::RestSolution rest;
  rest.utilisation = joint.utilisation(reaction, u, moment.dot(u));
  rest.direction = moment.isZero(0) ? Vector3d(Vector3d::Zero()) : u;
  rest.slip = joint.solve(reaction, u, moment.isZero(0) ? 0 : 1);
  rest.status = rest.slip.status;
  rest.solves = 1;
  return rest;
}

}  // namespace

AnyJoint::AnyJoint(const contact::JointContact& contact)
    : joint_(make(contact)) {}

const contact::JointContact& AnyJoint::contact() const {
  return std::visit(
      [](const auto& joint) -> const contact::JointContact& {
        return joint.contact();
      },
      joint_);
}

JointSolution AnyJoint::solve(const Vector3d& reaction,
                              const Vector3d& rate) const {
  if (const auto* ball = std::get_if<BallJoint>(&joint_)) {
    return ball->solve(reaction, rate);
  }
  return std::get<PinJoint>(joint_).solve(reaction, axis_of(rate, reaction),
                                          rate.stableNorm());
}

JointSolution AnyJoint::solve_contact(const Vector3d& force,
                                      const Vector3d& rate) const {
  if (const auto* ball = std::get_if<BallJoint>(&joint_)) {
    return ball->solve_contact(force, rate);
  }
  return std::get<PinJoint>(joint_).solve_contact(force, axis_of(rate, force),
                                                  rate.stableNorm());
}

contact::RestSolution AnyJoint::utilisation(const Vector3d& reaction,
                                            const Vector3d& moment) const {
  if (const auto* ball = std::get_if<BallJoint>(&joint_)) {
    return ball->utilisation(reaction, moment);
  }
  return pin_utilisation(std::get<PinJoint>(joint_), reaction, moment);
}

contact::FixedPointResult AnyJoint::fixed_point(
    const Vector3d& reaction, const Vector3d& rate,
    std::span<contact::FixedPointStep> trace, double start) const {
  constexpr double tolerance = 1e-12;
  const int steps = static_cast<int>(trace.size());
  if (const auto* ball = std::get_if<BallJoint>(&joint_)) {
    return ball->fixed_point(reaction, rate, trace, tolerance, steps, start);
  }
  return std::get<PinJoint>(joint_).fixed_point(
      reaction, axis_of(rate, reaction), rate.stableNorm(), trace, tolerance,
      steps, start);
}

}  // namespace hinge_joint
