// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "libcontact/joint/moment_set.hpp"
#include "libcontact/play/force_law.hpp"
#include "libcontact/play/hunt_crossley.hpp"

namespace contact {

/// How the ball or pin stands and moves relative to its seat or hole, in any
/// frame that is fixed to the seat.
struct PlayMotion {
  Eigen::Vector3d position;  ///< e, from the seat's centre to the ball's, m
  Eigen::Vector3d velocity;  ///< de/dt, m/s
  Eigen::Vector3d angular_velocity;  ///< Dw of the ball or pin, rad/s
  /// Axis of a pin, unit vector; motions along it have no effect.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
};

/// Load on the ball or pin. The seat has the opposite force at the same point:
/// -force and seat_moment() at its own centre.
struct PlayForce {
  Eigen::Vector3d force;   ///< N
  Eigen::Vector3d moment;  ///< about the centre of the ball or pin, N m
  double penetration;      ///< delta, m; negative where it is free
  double normal_force;     ///< N = F (1 + a d delta/dt), >= 0, N
  double energy;           ///< W, J
  double damping_power;    ///< -F a (d delta/dt)^2, W
  double friction_power;   ///< part of friction alone, W

  Eigen::Vector3d seat_moment(const PlayMotion& motion) const {
    return -moment - motion.position.cross(force);
  }
};

/// Derivatives of force and moment (rows) over position, velocity and angular
/// velocity
/// (columns, three each).
using PlayDerivatives = Eigen::Matrix<double, 6, 9>;

/// Largest friction of a pin at one place, whatever its motion: a force T
/// along axis x n, which has the moment rho T, and a moment M of its own. A pin
/// whose slip is 0 is held by all T in [-force, force] and M in [-moment,
/// moment].
struct FrictionBounds {
  double force;   ///< N
  double moment;  ///< N m
};

/// A joint with play as a force law, without any constraint: position and
/// velocity in, force and moment out, with derivatives, energy and the function
/// whose zero is touching and parting. For simulators, which integrate the
/// motion of the two bodies: docs/how-to/play.md.
///
/// Dry friction follows the sliding at each point of the contact. The
/// translation's part is taken at the contact's centre: right where the joint
/// turns much faster than its centre moves round, or touches with a half-angle
/// below some 10 deg. A regularised friction, v/sqrt(v^2 + vs^2) instead of the
/// direction of v, lets a joint at rest creep by vs T/(f0 N); friction_bounds()
/// and moment_set() hold it exactly.
///
/// Copies share their tables; const functions do not throw or allocate.
///
/// Accuracy (play/play_joint_test.cpp, against central differences):
/// derivatives of pins within 1e-7 of their largest, of balls, whose friction's
/// are differences themselves, 1e-6.
class PlayJoint {
 public:
  struct Options {
    HuntCrossley damping = {};
    /// vs, m/s, > 0; without influence if there is no friction.
    double regularisation_speed = 1e-3;
  };
  /// @throws Error as ForceLaw does, for friction that is not dry and for a
  ///   speed out of range.
  PlayJoint(const JointSpec& joint, const Options& options)
      : PlayJoint(joint, options, ForceLaw(joint)) {}
  /// @param law  of the same joint
  PlayJoint(const JointSpec& joint, const Options& options, ForceLaw law);

  /// The same joint with the damping of one impact's speed, for a restitution
  /// that is the same at every speed.
  PlayJoint with_damping(const HuntCrossley& damping) const {
    PlayJoint other = *this;
    other.options_.damping = damping;
    return other;
  }

  /// NaN beyond the end of the force law.
  PlayForce operator()(const PlayMotion& motion) const noexcept;
  /// The same, and its derivatives; at touch those from the contact's side.
  PlayForce operator()(const PlayMotion& motion,
                       PlayDerivatives& derivatives) const noexcept;

  /// delta and d delta/dt: the event function of touching (from below) and
  /// parting.
  double penetration(const PlayMotion& motion) const noexcept;
  double penetration_rate(const PlayMotion& motion) const noexcept;

  /// Bounds for a pin, by the elastic force.
  FrictionBounds friction_bounds(const PlayMotion& motion) const noexcept;
  /// Moments of a ball that act on Dw + (n x de/dt)/rho, by the elastic force;
  /// refers to this joint, which must have friction.
  MomentSet moment_set(const PlayMotion& motion) const noexcept;

  /// Notes where a motion leaves the model: beyond the force law; a translation
  /// that matters beside the turning in a wide contact. Empty inside it.
  std::vector<std::string> notes(const PlayMotion& motion) const;

  const ForceLaw& force_law() const noexcept { return law_; }
  const HuntCrossley& damping() const noexcept { return options_.damping; }

 private:
  struct Coefficients;
  template <class Real>
  struct Touch;
  template <class Real>
  struct Wrench;
  template <class Real>
  Wrench<Real> wrench(const PlayMotion& motion) const;
  template <class Real>
  void add_ball_friction(const Touch<Real>& touch, Wrench<Real>& to) const;
  template <class Real>
  void add_pin_friction(const Touch<Real>& touch, Wrench<Real>& to) const;
  Coefficients coefficients(double half_angle, double axis) const noexcept;
  Eigen::Vector3d offset(const PlayMotion& motion) const noexcept;

  ForceLaw law_;
  Options options_;
  double coefficient_ = 0;               // f0
  double adhesion_ = 0;                  // A, Pa
  std::optional<JointContact> contact_;  // with friction
};

}  // namespace contact
