// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "libcontact/joint/solution.hpp"
#include "multibody/friction/hinge_friction.hpp"
#include "multibody/system/force_model.hpp"

/// View of a motion at one time.
namespace multibody {

/// State of a hinge at one time; body axes. If no consistent friction moments
/// are found, or several are, forces and moments are NaN, and `joints` is
/// empty.
struct HingeSample {
  HingeMode mode;
  /// C: body axes to carrier axes.
  Eigen::Matrix3d rotation;
  Eigen::Vector3d relative_angular_velocity;  ///< exactly 0 at rest, rad/s
  double angle;                               ///< axis only, rad
  double angle_rate;                          ///< axis only, rad/s
  Eigen::Vector3d reaction_force;  ///< R, with the force of friction, N
  /// Moment about the hinge's centre; at rest and locked: the whole held
  /// moment, else without friction_moment; N m. With that of a stop.
  Eigen::Vector3d reaction_moment;
  Eigen::Vector3d friction_moment;  ///< sliding: M_t on the body, N m
  /// resting: tau, the needed moment over the largest moment that friction
  /// holds; sliding with friction: 1; NaN otherwise.
  double utilisation;
  double dissipated;  ///< by friction since the start, >= 0, J
  /// Moment of a stop about its axis on the body, beyond the moment held by
  /// friction, >= 0, N m. See HingeStop.
  double stop_moment;
  /// One solution per joint of the hinge, in the order of the group; empty
  /// without friction or if locked or released. At rest: the impending slip.
  /// There, and where a ball joint begins or ends to slide, power and slip
  /// velocity refer to 1 rad/s. For a ball in a seat that ends,
  /// contact::Joint::rims() returns the contact.
  std::span<const contact::JointSolution> joints;
};

/// Energies and works since the start, J.
struct EnergyBook {
  double kinetic;
  double gravity;      ///< potential of uniform gravity, 0 at the origin
  double active_work;  ///< done by the force model
  double dissipated;   ///< by the friction of all hinges
  double impacts;      ///< dissipated by stops and latches
  /// kinetic + gravity - active_work + dissipated + impacts: constant without
  /// work of a carrier drive.
  double balance() const {
    return kinetic + gravity - active_work + dissipated + impacts;
  }
};

class Equations;
class Hinges;
class Stepper;

/// The motion at one time, possibly in the middle of a step. Kinematics are
/// available at once; forces are computed on first use, from a copy of the
/// motion's memory: queries have no side effects.
class MotionSample {
 public:
  double time() const { return time_; }
  /// Carrier, then the bodies.
  std::span<const BodyMotion> motions() const;
  const BodyMotion& carrier() const { return motions()[0]; }
  const BodyMotion& body(int body) const { return motions()[1 + body]; }
  HingeMode mode(int body) const;
  /// Angle of a body on an axis, rad: cheap, without evaluating forces.
  double angle(int body) const;
  /// Whether a body rests on a rigid stop, where a ball joint may turn along
  /// it.
  bool rests_on_stop(int body) const;
  /// Computes accelerations and reactions.
  HingeSample hinge(int body) const;
  /// Accelerations of motions()[place]: of the centre of mass, gravity
  /// included, and angular; inertial axes.
  Eigen::Vector3d acceleration(int place) const;
  Eigen::Vector3d angular_acceleration(int place) const;
  EnergyBook energy() const;

  // Functions below are for the motion itself: they change the view.
  /// Keeps a reference to the equations.
  explicit MotionSample(const Equations& equations);
  ~MotionSample();
  MotionSample(const MotionSample&) = delete;
  MotionSample& operator=(const MotionSample&) = delete;
  void show(double time, std::span<const double> state);
  /// Moves the view within the last step; exact at its ends.
  void show(Stepper& stepper, double time);
  /// As above, approximate inside the step, at hardly any cost.
  void show_estimate(Stepper& stepper, double time);
  /// Computes accelerations and reactions once; false: they do not exist.
  bool work_out() const;
  /// All hinges, after they have been computed.
  Hinges hinges() const;
  /// Utilisation of a resting hinge; NaN where the evaluation fails.
  double utilisation(int body) const;
  const std::vector<double>& state() const { return state_; }
  /// Relative angular velocity, link axes.
  Eigen::Vector3d rate_of(int body) const;
  /// Keeps the angle when the body is released.
  void keep_hinge_angle(int body, double angle);
  /// Whether accelerations and reactions were used since the last call.
  bool was_asked() { return std::exchange(asked_, false); }

 private:
  struct Instant;
  void keep_at_stops(std::span<const double> begin);

  const Equations& equations_;
  double time_ = 0;
  std::vector<double> state_, trial_;
  std::unique_ptr<Instant> now_;
  mutable bool asked_ = false;
};

/// An application's event: a function that crosses 0. It must be continuous
/// between changes of hinges and breaks of the forces. Two crossings within one
/// step are found if the function is about a polynomial of degree 6 over the
/// step; otherwise set MotionOptions::longest_step. With a bound on its rate
/// all rising crossings are found, except rises above 0 by less than
/// `negligible`.
struct MotionEvent {
  enum class Crossing { rising, falling, either };
  std::function<double(const MotionSample&)> function;
  Crossing crossing = Crossing::either;
  /// A bound on the magnitude of its rate while bodies keep their velocities;
  /// for rising events only.
  std::function<double(const MotionSample&)> speed = {};
  double negligible = 0;
};

}  // namespace multibody
