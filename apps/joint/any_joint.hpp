#pragma once

#include <Eigen/Core>
#include <span>
#include <variant>

#include "libcontact/joint/ball_joint.hpp"
#include "libcontact/joint/pin_joint.hpp"

/// The parts of the program hinge-joint.
namespace hinge_joint {

/// A ball or a pin joint behind one interface. A pin turns about the
/// direction of the rate (at rest: of the moment); if that is 0 the axis is
/// taken normal to the force.
class AnyJoint {
 public:
  explicit AnyJoint(const contact::JointContact& contact);

  const contact::JointContact& contact() const;
  bool is_pin() const {
    return std::holds_alternative<contact::PinJoint>(joint_);
  }

  /// As the functions of contact::BallJoint.
  contact::JointSolution solve(const Eigen::Vector3d& reaction,
                               const Eigen::Vector3d& rate) const;
  contact::JointSolution solve_contact(const Eigen::Vector3d& force,
                                       const Eigen::Vector3d& rate) const;
  contact::RestSolution utilisation(const Eigen::Vector3d& reaction,
                                    const Eigen::Vector3d& moment) const;
  /// Until it has converged to 1e-12, or the trace is full.
  contact::FixedPointResult fixed_point(
      const Eigen::Vector3d& reaction, const Eigen::Vector3d& rate,
      std::span<contact::FixedPointStep> trace, double start) const;

 private:
  std::variant<contact::BallJoint, contact::PinJoint> joint_;
};

}  // namespace hinge_joint
