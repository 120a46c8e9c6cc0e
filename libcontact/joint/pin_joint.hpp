#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <utility>

#include "libcontact/joint/contact.hpp"
#include "libcontact/joint/solution.hpp"

namespace contact {

/// Friction of a pin in a hole under a known reaction.
///
/// With the half-angle theta0(R_n/l) of the pin's law, P = R_n/l and S(theta0)
/// of the pressure law (PressureLaw::force_ratio())
///
///     f  = tan g = f0 + 2 A rho l sin(theta0)/R_n,  R_n = R cos g
///     M_t = rho (f0 R_n S + 2 A rho l theta0) about the axis
///
/// for dry friction; for viscous friction with k1 rho |w| in place of f0 and
/// k0 rho |w| in place of A. Without adhesion f = f0 and nothing is left to
/// solve. It is the equation of BallJoint at a = 0: the results have the
/// same form, with b = 90 deg and a = 0.
///
/// Frame, sides and signs as in BallJoint; `rate` is the angular velocity
/// of the body relative to the carrier about `axis`. The joint takes force
/// normal to the axis only: the part of R along the axis is left out, and
/// JointSolution::reaction is what is left.
///
/// Const functions do not allocate and do not throw. NaN or infinity: NaN
/// with out_of_range.
class PinJoint {
 public:
  /// @throws Error if an argument does not fit a pin joint
  ///         (JointContact::JointContact).
  explicit PinJoint(JointContact contact);
  PinJoint(JointGeometry geometry, ElasticPair pair, FrictionModel friction,
           std::shared_ptr<const HalfAngleLaw> half_angle_law,
           std::shared_ptr<const PressureLaw> pressure_law)
      : PinJoint(JointContact(geometry, std::move(pair), friction,
                              std::move(half_angle_law),
                              std::move(pressure_law))) {}

  const JointContact& contact() const { return contact_; }

  /// Friction under the reaction R while the halves turn.
  ///
  /// @param reaction  R on the body, N
  /// @param axis      unit vector
  /// @param rate      rad/s about the axis; exactly 0 gives
  ///                  JointState::resting
  /// @return |f/tan g - 1| <= 2e-13 (joint/pin_joint_test.cpp)
  JointSolution solve(const Eigen::Vector3d& reaction,
                      const Eigen::Vector3d& axis, double rate,
                      const SolveOptions& options = {}) const noexcept;
  /// The same, starting from a solution for a similar R.
  JointSolution solve(const Eigen::Vector3d& reaction,
                      const Eigen::Vector3d& axis, double rate,
                      const JointSolution& last,
                      const SolveOptions& options = {}) const noexcept;

  /// Friction under a known normal force, see
  /// BallJoint::solve_contact().
  JointSolution solve_contact(const Eigen::Vector3d& normal_force,
                              const Eigen::Vector3d& axis,
                              double rate) const noexcept;

  /// The paper's inner loop, see BallJoint::fixed_point().
  FixedPointResult fixed_point(const Eigen::Vector3d& reaction,
                               const Eigen::Vector3d& axis, double rate,
                               std::span<FixedPointStep> trace,
                               double tolerance = 1e-12, int step_limit = 1000,
                               double start = 0) const noexcept;

  /// Largest moment about the axis that the joint holds at rest under R, N m:
  /// that of sliding. 0 for viscous friction. The moments it holds are the
  /// interval between -limit and limit.
  double moment_limit(const Eigen::Vector3d& reaction,
                      const Eigen::Vector3d& axis) const noexcept;
  /// |moment|/moment_limit(): the joint holds if it is <= 1. 0 at moment 0.
  /// @param moment  about the axis, N m
  double utilisation(const Eigen::Vector3d& reaction,
                     const Eigen::Vector3d& axis, double moment) const noexcept;

 private:
  JointContact contact_;
};

}  // namespace contact
