// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "libcontact/joint/step.hpp"

namespace contact {

/// A joint among the generalized rates of a simulator.
struct MechanismJoint {
  const Joint* joint;
  /// The first of its rates: Dw of a ball in any axes, three; the rate of a pin
  /// about its axis, one.
  int first;
};

/// State of a joint in a simulator at the start of a step.
struct MechanismStart {
  /// R on the body in the previous step, N: for a ball in the axes of its
  /// rates, for a pin in the axes of `axis`.
  Eigen::Vector3d reaction;
  /// Unit axis of a pin.
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  /// For a ball with a [seat]: rotation from the axes of the body with the seat
  /// to the axes of the rates.
  Eigen::Matrix3d from_seat = Eigen::Matrix3d::Identity();
};

/// Time steps of a mechanism with joint friction in a simulator's own
/// coordinates: step() of all joints, alternating with constraints that the
/// simulator solves. H q'' = forces + J^T lambda + friction; the rates at the
/// end of a step are q' + dt q''. In each step, `force` of friction being 0:
///
///     weigh(H, J, D, dt); begin(starts, q', likely);
///     do { turn(q' + dt q'', force); q'' with this force; weigh(...); }
///     while there are constraints and the force still changes
///
/// Rates of joints that hold() are exactly 0: the simulator must keep them and
/// their angles as they are, even where its rounding would move them.
///
/// Accuracy: as step(), 1e-12 of the moments in a turn. Constraints count in W
/// as far as they are linear in the acceleration (rows of J with stiffness D);
/// turns settle in one without others, and in 2 to 10 with contacts.
class MechanismStep {
 public:
  /// @param size  number of generalized rates
  /// @throws Error for joints whose rates overlap or are none of these
  MechanismStep(const std::vector<MechanismJoint>& joints, int size);
  /// Starts point at placements.
  MechanismStep(const MechanismStep&) = delete;
  MechanismStep(MechanismStep&&) = default;

  /// W = the Schur complement of (H + J^T D J) in the joints' rates over dt.
  /// @param inertia     H, (size, size), symmetric, with dt times dampings
  /// @param rows        J, (n, size): constraints whose force is linear
  /// @param stiffness   D, (n)
  /// @param time_step   dt, s, > 0
  /// @throws Error for other sizes and numbers
  void weigh(const Eigen::Ref<const Eigen::MatrixXd>& inertia,
             const Eigen::Ref<const Eigen::MatrixXd>& rows,
             const Eigen::Ref<const Eigen::VectorXd>& stiffness,
             double time_step);

  /// Starts a step.
  /// @param rates   q', (size)
  /// @param likely  a guess of the rates at the end, for speed
  /// @throws Error for other sizes, and a from_seat that is no rotation
  void begin(std::span<const MechanismStart> starts,
             const Eigen::Ref<const Eigen::VectorXd>& rates,
             const Eigen::Ref<const Eigen::VectorXd>& likely);

  /// Replaces the present friction force.
  /// @param rates_at_end  q' + dt q'' with the friction `force`, (size)
  /// @param force         generalized force of friction, (size): changed in the
  ///                      joints' rates alone
  /// @return |change of force|/|force|, 0 if both are 0
  /// @throws Error for other sizes, and before weigh() and begin()
  double turn(const Eigen::Ref<const Eigen::VectorXd>& rates_at_end,
              Eigen::Ref<Eigen::VectorXd> force);

  /// The force that would keep the rates constant, for the reactions of the
  /// first step.
  /// @throws Error for other sizes, and before weigh()
  Eigen::VectorXd holding_force(
      const Eigen::Ref<const Eigen::VectorXd>& rates,
      const Eigen::Ref<const Eigen::VectorXd>& rates_at_end) const;

  /// Steps of the last turn, in the axes of the rates.
  const std::vector<JointStep>& steps() const { return steps_; }
  const StepSweeps& sweeps() const { return sweeps_; }

 private:
  bool is_pin(std::size_t i) const { return joints_[i]->is_pin(); }
  Eigen::Vector3d rate_of(std::size_t i,
                          const Eigen::Ref<const Eigen::VectorXd>& q) const;
  void check(const char* name, Eigen::Index found) const;

  std::vector<const Joint*> joints_;
  std::vector<int> first_;
  std::vector<int> own_;    // rates with friction, joint by joint
  std::vector<int> other_;  // and without
  std::vector<StepStart> starts_;
  std::vector<Placement> placements_;
  std::vector<JointStep> steps_;
  StepSweeps sweeps_;
  bool has_begun_ = false;
  Eigen::MatrixXd weight_;  // W
};

}  // namespace contact
