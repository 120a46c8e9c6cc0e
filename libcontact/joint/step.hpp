// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>

#include "libcontact/joint/joint.hpp"

namespace contact {

/// A joint at the start of a time step of an external simulator.
struct StepStart {
  /// R on the body, N, of the step before or as good as it is known.
  Eigen::Vector3d reaction;
  /// Dw, rad/s; exactly 0: the joint rests.
  Eigen::Vector3d angular_velocity;
  /// Dw at the end of the step if this joint had no friction, rad/s.
  Eigen::Vector3d free;
  /// Axis of a pin, unit vector; 0: the direction of Dw or of `free`.
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  /// The placement of a seat; null: the vectors are in its axes.
  const Placement* placement = nullptr;
};

/// The same joint at the end of the step.
struct JointStep {
  /// The worst of friction, rest and motion.
  Status status = Status::out_of_range;
  /// Dw, rad/s; exactly 0 where the joint holds.
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();
  /// M_t on the body during the step, N m.
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  bool holds = false;
  /// Friction at the start; of incipient sliding where the joint rested.
  JointSolution solution;
  /// Joint::at_rest() with the moment it had to hold, if the joint rested.
  RestSolution rest;
};

/// Whether W is one that step() takes: of a ball symmetric, to the 1e-6 of
/// hosts that compute in single precision, and positive definite; of a pin
/// positive about its axis.
bool is_inertia(const Joint& joint, const StepStart& start,
                const Eigen::Matrix3d& inertia) noexcept;
/// The same for messages of hosts that refuse others.
inline constexpr std::string_view inertia_rule =
    "symmetric and positive definite, of a pin positive about its axis";

/// One implicit step with friction, which comes to rest, holds and lets go.
///
/// A torque of solve() alone never stops a body: it overshoots, and creeps.
/// Here the motion without friction, `free`, becomes the one with it: M_t and
/// Dw at the end satisfy
///
///     M_t = W (Dw - free),   W = (inertia about the joint)/(time step)
///
/// with M_t opposite to Dw, as MomentSet::prox() has it. A joint that rests
/// stays at Dw = 0 as long as Joint::at_rest() holds W free. n, R_n and theta0
/// are those at the start (of incipient sliding, if it rests). Viscous friction
/// is linear in Dw; a friction stress has the strength of the speed at the
/// start, and no step of a ball if it falls with the speed
/// (JointContact::rest_refusal()): out_of_range.
///
/// @param inertia  W, N m s, as is_inertia() has it, else out_of_range; of a
///                 pin its part along the axis counts
/// @param last     the step before, for speed
/// @return the equation to 1e-12 of |W free|, contacts of some mrad to 2e-9
///         (joint/step_test.cpp). Does not throw, and does not allocate but for
///         a contact in a seat that ends.
JointStep step(const Joint& joint, const StepStart& start,
               const Eigen::Matrix3d& inertia,
               const JointStep& last = {}) noexcept;

/// How steps of several joints have come to fit each other.
struct StepSweeps {
  /// not_converged: the joints do not fit yet, and have what was found.
  Status status = Status::out_of_range;
  int sweeps = 0;
  /// Largest change of a joint's moment in the last sweep over the largest
  /// W_ii free; infinite if other joints hold than before.
  double residual = 0;
};

/// The same of joints of one mechanism, whose motions depend on each other:
///
///     M_i = sum_j W_ij (Dw_j - free_j)
///
/// by Newton's method for those that move and, where it ends as one stops or
/// lets go, by sweeps over the joints, each with step() and the moments of the
/// others (block Gauss-Seidel; those that hold stay at 0 until they let go).
///
/// @param inertia  W: mass matrix over the time step in the joints'
///                 angular velocities, three rows for a ball and one, about its
///                 axis, for a pin; symmetric, positive definite. Joints'
///                 frames may differ.
/// @param steps    in: the last step's, or empty ones; a better guess
///                 of Dw than the one of `starts` may replace it, for
///                 speed; out: the result
/// @param tolerance  of StepSweeps::residual
/// @throws Error if sizes differ, a pin has no axis, or W is not symmetric or a
///         joint's block of it not as is_inertia() has it.
StepSweeps step(std::span<const Joint* const> joints,
                std::span<const StepStart> starts,
                const Eigen::Ref<const Eigen::MatrixXd>& inertia,
                std::span<JointStep> steps, double tolerance = 1e-12);

}  // namespace contact
