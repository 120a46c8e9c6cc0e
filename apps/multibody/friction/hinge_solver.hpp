#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "multibody/friction/hinge_friction.hpp"
#include "multibody/system/active_forces.hpp"
#include "multibody/system/system.hpp"

namespace multibody {

/// Friction of one hinge under a known reaction, between link axes and the
/// joint solvers of libcontact, which use body axes. Allocates only in seats
/// that end.
class HingeSolver {
 public:
  /// Last solutions, from which the next ones start; body axes.
  struct Memory {
    std::vector<contact::JointSolution> joints;
    contact::JointGroup::Solution group;
    contact::RestSolution rest;
    /// Rotation from the seat's body to the body, for a seat on the carrier.
    contact::Placement placement;
    /// Direction of impending slip in the last utilisation(), unit vector; 0
    /// without a driving moment.
    Eigen::Vector3d slip_direction = Eigen::Vector3d::Zero();
  };

  /// @param body  for messages
  /// @throws contact::Error if friction does not suit the kind of hinge
  HingeSolver(HingeFriction friction, const Link& link, int body);

  /// Without solutions.
  Memory make_memory() const;
  /// Sets the rate of a turning hinge; call before the functions below.
  void set_state(const double* link_state, Memory& memory) const {
    if (turns_seat_) place_seat(link_state, memory);
  }
  bool has_friction() const { return !contacts_.empty(); }
  /// Whether at least one joint has dry friction above 0.
  bool can_rest() const { return can_rest_; }
  bool is_axis() const { return is_axis_; }

  /// M_t on the body, link axes (axis: along z) while it turns with `rate`
  /// (axis: about z, not 0). NaN where the joint solver fails.
  Eigen::Vector3d slide(const Reaction<double>& reaction,
                        const Eigen::Vector3d& rate, Memory& memory) const;

  /// dM_t/dR after slide() with the same arguments, link axes (axis: row of z),
  /// m; none if the joints do not provide it.
  std::optional<Eigen::Matrix3d> slope(const Reaction<double>& reaction,
                                       const Eigen::Vector3d& rate,
                                       const Memory& memory) const;

  /// tau: moment that `held` needs over the moment that friction can hold; NaN
  /// if a contact has no value.
  /// @param held  force on the held body in the hinge, and moment about the
  ///              hinge's centre
  double utilisation(const Reaction<double>& held, Memory& memory) const;

  /// Motion with friction, for the contact of the last slide(): relative
  /// angular acceleration, see contact::MomentSet::prox(). Ball joints only.
  Eigen::Vector3d prox(const Eigen::Matrix3d& inertia,
                       const Eigen::Vector3d& free, const Memory& memory) const;

  /// M_t of a joint in the last call, link axes.
  Eigen::Vector3d joint_moment(int joint, const Memory& memory) const {
    return axes_.transpose() * memory.joints[joint].friction_moment;
  }
  /// The joint that caused NaN in the last call.
  static int failed_joint(const Memory& memory);
  const contact::JointContact& contact(int joint) const {
    return contacts_[joint];
  }

 private:
  contact::Joint::Slip slip_of(const Reaction<double>& reaction,
                               const Eigen::Vector3d& rate,
                               const Memory& memory) const;
  bool solve_group(const Reaction<double>& reaction, double rate,
                   Memory& memory) const;
  double moment_limit(const Reaction<double>& held, double sign,
                      Memory& memory) const;
  void estimate_joints(const contact::JointGroup& group, double rate,
                       Memory& memory) const;
  double utilisation_of(const JointFriction& ball,
                        const contact::Joint::Hold& hold, Memory& memory) const;

  void place_seat(const double* link_state, Memory& memory) const;
  // Null if the seat's axes are the body's axes.
  const contact::Placement* placement(const Memory& memory) const {
    return turns_seat_ ? &memory.placement : nullptr;
  }

  HingeFriction friction_;
  std::vector<contact::JointContact> contacts_;
  Link link_;
  Eigen::Matrix3d axes_;  // link axes to body axes
  bool is_axis_;
  bool can_rest_ = false;
  bool turns_seat_ = false;  // the carrier has the seat of a contact that ends
};

}  // namespace multibody
