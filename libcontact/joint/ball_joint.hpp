#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <utility>

#include "libcontact/joint/contact.hpp"
#include "libcontact/joint/moment_set.hpp"
#include "libcontact/joint/solution.hpp"

namespace contact {

/// What a resting joint holds, see BallJoint::utilisation().
struct RestSolution {
  /// As the slip's; not_converged if no slip direction was found.
  Status status = Status::out_of_range;
  /// tau: the joint holds if it is <= 1. Infinite if there is no friction to
  /// hold a moment, NaN if out_of_range or no slip direction was found.
  double utilisation = 0;
  /// u, unit vector: the direction in which the joint would begin to slide;
  /// 0 if M = 0.
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  /// The sliding about u (|Dw| = 1 rad/s) whose moment is M/tau: n, R_n,
  /// theta0. JointState::resting if M = 0.
  JointSolution slip;
  /// Sliding solutions that were needed.
  int solves = 0;
};

/// Friction of a ball in a seat under a known reaction.
///
/// The reaction R is the sum of the normal force R_n n and the friction
/// force R_t normal to it; n, R_n, the half-angle theta0 and the friction
/// coefficient depend on each other. docs/joint.md has the equations.
///
/// Frame: any, the same for all vectors. R, R_t, M_t act on the body; Dw is
/// the angular velocity of the body relative to the carrier. If the carrier
/// has the ball, n points from the joint's centre to the contact's; if the
/// body has it, away from it. Either way R_n n is the push on the body.
///
/// Const functions do not allocate and do not throw. NaN or infinity in R or
/// Dw: NaN with out_of_range.
class BallJoint {
 public:
  /// @throws Error if an argument does not fit a ball joint
  ///         (JointContact::JointContact).
  explicit BallJoint(JointContact contact);
  BallJoint(JointGeometry geometry, ElasticPair pair, FrictionModel friction,
            std::shared_ptr<const HalfAngleLaw> half_angle_law,
            std::shared_ptr<const PressureLaw> pressure_law)
      : BallJoint(JointContact(geometry, std::move(pair), friction,
                               std::move(half_angle_law),
                               std::move(pressure_law))) {}

  const JointContact& contact() const { return contact_; }

  /// Friction under the reaction R while the halves turn with Dw.
  ///
  /// @param reaction  R on the body, N; 0 gives JointState::unloaded
  /// @param rate      Dw, rad/s; exactly 0 gives JointState::resting: whether
  ///                  a joint rests is the caller's to say, see utilisation()
  JointSolution solve(const Eigen::Vector3d& reaction,
                      const Eigen::Vector3d& rate,
                      const SolveOptions& options = {}) const noexcept;
  /// The same, starting from a solution for a similar R and Dw.
  JointSolution solve(const Eigen::Vector3d& reaction,
                      const Eigen::Vector3d& rate, const JointSolution& last,
                      const SolveOptions& options = {}) const noexcept;

  /// Friction under a known normal force: nothing to solve. With R in
  /// its place it is the traditional estimate of friction.
  ///
  /// @param normal_force  R_n n on the body, N
  /// @param rate               Dw, rad/s
  JointSolution solve_contact(const Eigen::Vector3d& normal_force,
                              const Eigen::Vector3d& rate) const noexcept;

  /// Whether the joint rests under R while holding the moment M, and how near
  /// it is to sliding.
  ///
  /// While a joint rests n is not known. Consistent with sliding, it holds
  ///
  ///     H(R) = { tau M_t(R, u) : |u| = 1, 0 <= tau <= 1 },
  ///
  /// M_t(R, u) the moment of solve(): the onset of slip and the limit of slow
  /// sliding agree. For a needed moment, M = tau M_t(R, u) is solved: by the
  /// symmetry about R one equation in the angle b of u and R. Were there
  /// several u, the smallest tau of those that 16 intervals of b tell apart
  /// is returned (none of 10,000 random joints had more than one). A viscous
  /// joint holds no moment.
  ///
  /// @param reaction  R on the body, N
  /// @param moment    M on the body that friction has to supply, N m
  /// @return slip.friction_moment = M/tau, to 1e-12 of |M|/tau
  ///         (joint/ball_joint_rest_test.cpp)
  RestSolution utilisation(const Eigen::Vector3d& reaction,
                           const Eigen::Vector3d& moment,
                           const SolveOptions& options = {}) const noexcept;
  /// The same, starting from an answer for a similar R and M; looks for one
  /// u only, the one close to the last.
  RestSolution utilisation(const Eigen::Vector3d& reaction,
                           const Eigen::Vector3d& moment,
                           const RestSolution& last,
                           const SolveOptions& options = {}) const noexcept;

  /// The moments that the contact of a solution holds at fixed n, R_n and
  /// theta0: what a solver of several bodies iterates on. The set refers to
  /// this joint and must not outlive it.
  MomentSet moment_set(const JointSolution& solution) const& noexcept {
    return {contact_, solution.normal, solution.normal_force,
            solution.half_angle};
  }
  /// Would refer to a joint that is gone.
  MomentSet moment_set(const JointSolution&) const&& = delete;

  /// The paper's inner loop (section 4): g_1 = 0, then a, R_n, theta0, f and
  /// g = atan f in turn. It may crawl or fail where solve() does not.
  ///
  /// @param trace      filled with the steps, as many as it has room for
  /// @param tolerance  stop when |f/tan g - 1| <= tolerance
  /// @param start      tan g_1, instead of the paper's 0: the last f, when the
  ///                   loop goes on under another reaction
  FixedPointResult fixed_point(const Eigen::Vector3d& reaction,
                               const Eigen::Vector3d& rate,
                               std::span<FixedPointStep> trace,
                               double tolerance = 1e-12, int step_limit = 1000,
                               double start = 0) const noexcept;

 private:
  JointContact contact_;
};

}  // namespace contact
