#pragma once

#include <Eigen/Core>
#include <string>

#include "hosts/joint_handle.hpp"

namespace contact_hosts {

/// Friction about the axis of a hinge, for hosts with fixed steps that add a
/// torque about the axis explicitly: w' = w + (step/inertia) (other torques +
/// torque).
///
/// The host need not know the rate without friction: the hinge is assumed to
/// gain as much rate as in the previous step. A hinge that holds comes to rest
/// within two steps, up to the rate that a change of the other torques causes
/// in one step. An inertia that is too small by any factor, or too large by
/// less than a third, only takes more steps (hosts/held_hinge_test.cpp).
class HeldHinge {
 public:
  /// @throws std::runtime_error if the file is not a pin with dry friction
  explicit HeldHinge(const std::string& file)
      : joint_(read_dry_joint(file, "HeldHinge", CONTACT_PIN)) {}

  /// @param reaction  R on the body in the previous step, N, in any frame
  /// @param axis      unit vector in the same frame
  /// @param rate      of the body relative to the carrier about the axis, rad/s
  /// @param inertia   about the axis, as the host's step uses it, kg m^2
  /// @param step      s
  /// @return torque on the body about the axis during the step, N m; the
  ///         opposite torque acts on the carrier
  double torque(const Eigen::Vector3d& reaction, const Eigen::Vector3d& axis,
                double rate, double inertia, double step) {
    const double gained = rate - last_rate_ - last_torque_ * step / inertia;
    const double free = rate + (is_first_ ? 0 : gained);
    last_torque_ = torque(reaction, axis, rate, free, inertia, step);
    last_rate_ = rate;
    is_first_ = false;
    return last_torque_;
  }

  /// As above, for hosts that know the rate without friction at the step's end.
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

  /// The last step: friction, contact, and whether the hinge held.
  const contact_step& last() const { return last_; }

 private:
  JointHandle joint_;
  contact_step last_ = {};
  double last_rate_ = 0;
  double last_torque_ = 0;
  bool is_first_ = true;
};

}  // namespace contact_hosts
