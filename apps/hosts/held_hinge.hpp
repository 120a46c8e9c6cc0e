#pragma once

#include <Eigen/Core>
#include <string>

#include "hosts/joint_handle.hpp"

namespace contact_hosts {

/// Friction about the axis of a hinge, for hosts with fixed steps that take a
/// torque about it and add it explicitly: w' = w + (step/inertia) (other
/// torques + torque).
///
/// The rate that the hinge would have without friction is not asked for: it is
/// taken to gain what it gained in the step before. A hinge that holds comes to
/// rest within two steps, with a rate of the change of the other torques in a
/// step; an inertia that is too small by any factor, or too large by less than
/// a third, only takes more steps (hosts/held_hinge_test.cpp).
class HeldHinge {
 public:
  /// @throws std::runtime_error if the file is not a pin with dry friction
  explicit HeldHinge(const std::string& file)
      : joint_(read_dry_joint(file, "HeldHinge", CONTACT_PIN)) {}

  /// @param reaction  R on the body, N, in any frame: that of the step before
  /// @param axis      unit, in the same frame
  /// @param rate      of the body relative to the carrier about it, rad/s
  /// @param inertia   about the axis, as the step has it, kg m^2
  /// @param step      s
  /// @return torque on the body about the axis during the step, N m; the
  ///         opposite one acts on the carrier
  double torque(const Eigen::Vector3d& reaction, const Eigen::Vector3d& axis,
                double rate, double inertia, double step) {
    const double gained = rate - last_rate_ - last_torque_ * step / inertia;
    const double free = rate + (is_first_ ? 0 : gained);
    last_torque_ = torque(reaction, axis, rate, free, inertia, step);
    last_rate_ = rate;
    is_first_ = false;
    return last_torque_;
  }

  /// The same where the host knows the rate without friction at the step's end.
  double torque(const Eigen::Vector3d& reaction, const Eigen::Vector3d& axis,
                double rate, double free, double inertia, double step) {
    contact_step_start start;
    Eigen::Vector3d::Map(start.reaction) = reaction;
    Eigen::Vector3d::Map(start.angular_velocity) = rate * axis;
    Eigen::Vector3d::Map(start.free) = free * axis;
    Eigen::Vector3d::Map(start.axis) = axis;
    Eigen::Matrix3d w = inertia / step * Eigen::Matrix3d::Identity();
    must(contact_joint_step(joint_.get(), &start, w.data(), &last_, &last_));
    return Eigen::Vector3d::Map(last_.moment).dot(axis);
  }

  /// Friction, contact and whether it holds, of the last step.
  const contact_step& last() const { return last_; }

 private:
  JointHandle joint_;
  contact_step last_ = {};
  double last_rate_ = 0;
  double last_torque_ = 0;
  bool is_first_ = true;
};

}  // namespace contact_hosts
