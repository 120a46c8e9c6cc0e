#pragma once

#include <Eigen/Core>
#include <vector>

#include "libcontact/base/vector_rows.hpp"
#include "multibody/dynamics/dynamics.hpp"
#include "multibody/friction/hinge_solver.hpp"
#include "multibody/tracking/joint_tracker.hpp"

namespace multibody {

/// Friction of all hinges side by side, tracked from evaluation to evaluation
/// (JointTracker): moments as functions of the reactions nearby, with one
/// evaluation of every contact. Link axes. Maps hinges to their joints; joints
/// that cannot be tracked need their HingeSolver.
class FrictionTracker {
 public:
  explicit FrictionTracker(const std::vector<HingeFriction>& friction);

  /// Starts from a hinge's last solution.
  /// @param rate  of that solution
  void start(int hinge, const HingeSolver& solver,
             const HingeSolver::Memory& last, const Eigen::Vector3d& rate);
  void stop(int hinge);
  bool is_tracked(int hinge) const {
    return all(hinge, &JointTracker::is_tracked);
  }
  /// As JointTracker::is_trusted(), of all joints of a hinge.
  bool is_trusted(int hinge) const {
    return all(hinge, &JointTracker::is_trusted);
  }
  /// Number of tracked hinges.
  int count() const { return count_; }

  void set_rate(int hinge, const Eigen::Vector3d& rate) {
    for (int k = 0; k < hinges_[hinge].joints; ++k) {
      joints_.set_rate(joint(hinge, k), rate);
    }
  }
  /// M_t of the computed motion (axis: along z).
  void set_applied_moment(int hinge, const Eigen::Vector3d& moment);
  Eigen::Vector3d applied_moment(int hinge) const {
    const auto [count, is_axis] = hinges_[hinge];
    Eigen::Vector3d sum = joints_.applied_moment(hinge);
    for (int k = 1; k < count; ++k) {
      sum += joints_.applied_moment(joint(hinge, k));
    }
    return is_axis ? Eigen::Vector3d(0, 0, sum.z()) : sum;
  }

  /// Reactions that the motion causes.
  void take_reactions(const Dynamics& dynamics);
  /// Force on a hinge among these reactions.
  Vec3<double> force(int hinge) const {
    if (is_direct_) {
      const Eigen::Vector3d r = joints_.reaction(hinge);
      return {r.x(), r.y(), r.z()};
    }
    constexpr int next = contact::VectorRows::lanes;
    const double* const f = rows_[hinge / next].force + hinge % next;
    return {f[0], f[next], f[2 * next]};
  }

  /// The joints of all hinges.
  JointTracker& joints() { return joints_; }
  /// Changes the motion after joints().apply().
  void move(Dynamics& dynamics);

 private:
  struct Hinge {
    int joints;  ///< 0: cannot be tracked
    bool is_axis;
  };
  /// Shares of the joints in the force and moment of a hinge, as in
  /// contact::JointGroup::Share; a number for each joint.
  struct Shares {
    std::vector<double> force, moment, axial;
  };
  /// 8 hinges.
  struct alignas(64) HingeRows {
    double force[24], moment[24], change[24];
  };
  contact::VectorRows rows(double (HingeRows::*vector)[24]) {
    return {rows_[0].*vector, sizeof(HingeRows) / sizeof(double)};
  }
  /// The k-th joints of all hinges lie side by side, so that lanes over hinges
  /// are lanes over joints; missing joints are never tracked.
  int joint(int hinge, int k) const { return k * row_ + hinge; }
  /// Whether this holds for all joints of a hinge that can be tracked.
  bool all(int hinge, bool (JointTracker::*of)(int) const noexcept) const;
  std::vector<contact::JointContact> lay_out(
      const std::vector<HingeFriction>& friction);
  void set_shares(int hinge, const HingeFriction& friction);
  void share_reactions();

  std::vector<Hinge> hinges_;
  int row_ = 0;    ///< joints side by side, a multiple of 4
  int depth_ = 0;  ///< most joints of a hinge
  /// Every hinge has one joint: rows of hinges are rows of joints.
  bool is_direct_ = true;
  JointTracker joints_;
  Shares shares_;
  std::vector<double> across_;  ///< 1: moments across the axis count as well
  std::vector<HingeRows> rows_;
  int count_ = 0;
};

}  // namespace multibody
