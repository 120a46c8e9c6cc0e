#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "libcontact/tracking/joint_tracker.hpp"
#include "multibody/dynamics/dynamics.hpp"
#include "multibody/friction/hinge_solver.hpp"
#include "multibody/system/active_forces.hpp"

namespace multibody {

/// Friction of all hinges side by side, tracked from evaluation to evaluation
/// (contact::JointTracker): moments as functions of the reactions nearby, with
/// one evaluation of every contact. Link axes. This is how hinges and the
/// joints in them correspond; where joints cannot be tracked the HingeSolvers
/// have to be asked.
class FrictionTracker {
 public:
  explicit FrictionTracker(const std::vector<HingeFriction>& friction);

  /// From a hinge's last solution.
  /// @param rate  with which that was found
  void start(int hinge, const HingeSolver& solver,
             const HingeSolver::Memory& last, const Eigen::Vector3d& rate);
  void stop(int hinge);
  bool is_tracked(int hinge) const;
  /// How many hinges are tracked.
  int count() const { return count_; }

  void set_rate(int hinge, const Eigen::Vector3d& rate) {
    const auto [first, end, is_axis] = hinges_[hinge];
    for (int k = first; k < end; ++k) joints_.set_rate(k, rate);
  }
  /// M_t that the motion has been worked out with (axis: along z).
  void set_applied_moment(int hinge, const Eigen::Vector3d& moment);
  Eigen::Vector3d applied_moment(int hinge) const {
    return sum(hinge, [&](int k) { return joints_.applied_moment(k); });
  }

  /// Whether motion and joints exchange rows of vectors: every hinge has one
  /// joint.
  bool is_direct() const { return is_direct_; }
  /// Reactions that the motion causes.
  /// @param reactions  filled by Dynamics::reactions() unless is_direct()
  void take_reactions(const Dynamics& dynamics, std::span<const int> hinges,
                      std::span<Reaction<double>> reactions);

  /// The force on a hinge of one joint among them.
  Vec3<double> force(int hinge) const {
    const Eigen::Vector3d r = joints_.reaction(hinges_[hinge].first);
    return {r.x(), r.y(), r.z()};
  }

  /// The joints of all hinges.
  contact::JointTracker& joints() { return joints_; }
  /// What joints().apply() changed: the motion follows.
  /// @param change  of each hinge, filled unless is_direct()
  void move(Dynamics& dynamics, std::span<const int> hinges,
            std::span<Vec3<double>> change);

 private:
  struct Hinge {
    int first, end;  ///< its joints, none: cannot be tracked
    bool is_axis;
  };
  void add(const HingeFriction& friction);
  void set_reactions(const Hinge& hinge, const Reaction<double>& reaction);
  /// Of vectors of a hinge's joints; on an axis along it.
  template <class F>
  Eigen::Vector3d sum(int hinge, F of) const {
    const auto [first, end, is_axis] = hinges_[hinge];
    Eigen::Vector3d sum = of(first);
    for (int k = first + 1; k < end; ++k) sum += of(k);
    return is_axis ? Eigen::Vector3d(0, 0, sum.z()) : sum;
  }

  std::vector<Hinge> hinges_;
  contact::JointTracker joints_;
  std::vector<contact::JointGroup::Share> shares_;
  int count_ = 0;
  bool is_direct_ = true;
};

}  // namespace multibody
