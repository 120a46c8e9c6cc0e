#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "multibody/friction/hinge_friction.hpp"
#include "multibody/system/active_forces.hpp"
#include "multibody/system/system.hpp"

namespace multibody {

/// Friction of one hinge under a known reaction, between link axes and the
/// joint solvers of libcontact, which work in body axes. Remembers its
/// last solutions as starts of the next. Does not allocate.
class HingeSolver {
 public:
  /// @param body  for messages
  /// @throws contact::Error if friction and kind of hinge do not go together
  HingeSolver(HingeFriction friction, const Link& link, int body);

  bool has_friction() const { return !joints_.empty(); }
  /// Dry friction, above 0, in at least one joint.
  bool can_rest() const { return can_rest_; }
  bool is_axis() const { return is_axis_; }

  /// M_t on the body, link axes (axis: along z) while it turns with `rate`
  /// (axis: about z, not 0). NaN where the joint solver fails.
  Eigen::Vector3d slide(const Reaction<double>& reaction,
                        const Eigen::Vector3d& rate);

  /// tau: share of the moments that friction can hold which `held` needs; NaN
  /// where a contact has no value.
  /// @param held  what acts on the held body in the hinge, its moment about
  ///              the hinge's centre included
  double utilisation(const Reaction<double>& held);
  /// Of the last utilisation(): where it would slide to, unit vector, body
  /// axes; 0 where nothing pushes it.
  const Eigen::Vector3d& slip_direction() const { return slip_direction_; }

  /// The motion that friction leaves, for the contact of the last slide():
  /// relative angular acceleration, see contact::MomentSet::prox(). Ball
  /// joints only.
  Eigen::Vector3d prox(const Eigen::Matrix3d& inertia,
                       const Eigen::Vector3d& free) const;

  /// M_t of a joint, last call, link axes.
  Eigen::Vector3d joint_moment(int joint) const {
    return axes_.transpose() * joints_[joint].friction_moment;
  }
  /// Of the last call, body axes.
  std::span<const contact::JointSolution> joints() const { return joints_; }
  /// If that gave NaN: the joint that it comes from.
  int failed_joint() const;
  const contact::JointContact& contact(int joint) const {
    return contacts_[joint];
  }

 private:
  bool solve_group(const Reaction<double>& reaction, double rate);
  double moment_limit(const Reaction<double>& held, double sign);
  void estimate_joints(const contact::JointGroup& group, double rate);
  double utilisation_of(const JointFriction& ball,
                        const contact::Joint::Hold& hold);

  HingeFriction friction_;
  std::vector<contact::JointContact> contacts_;
  Eigen::Matrix3d axes_;  // link axes to body axes
  bool is_axis_;
  bool can_rest_ = false;
  Eigen::Vector3d slip_direction_ = Eigen::Vector3d::Zero();
  std::vector<contact::JointSolution> joints_;
  contact::JointGroup::Solution group_;
  contact::RestSolution rest_;
};

}  // namespace multibody
