#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "multibody/friction/coupled_report.hpp"
#include "multibody/friction/hinge_friction.hpp"
#include "multibody/system/force_model.hpp"
#include "multibody/system/system.hpp"

namespace multibody {

/// Where a body is at the start.
struct BodyStart {
  /// ball: C, body axes to carrier axes, and the relative angular
  /// velocity, body axes. Exactly 0: the hinge begins at rest if its
  /// friction holds it.
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d relative_angular_velocity = Eigen::Vector3d::Zero();
  double angle = 0;       ///< axis, rad
  double angle_rate = 0;  ///< axis, rad/s; 0 as above
  /// A locked hinge does not move until unlock(); its rate has to be 0.
  bool locked = false;
  /// none: a body of its own.
  BodyMotion body{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                  Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()};
};

/// Where everything is at the start.
struct MotionStart {
  double time = 0;  ///< s
  BodyMotion carrier{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                     Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()};
  std::vector<BodyStart> bodies;  ///< one for each body
};

/// Motion of the carrier where it is prescribed.
struct CarrierDrive {
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  ///< inertial axes
  Eigen::Vector3d angular_acceleration = Eigen::Vector3d::Zero();  ///< carrier
};

/// How to step through time.
enum class Integrator {
  adaptive,  ///< explicit Runge-Kutta with error control (SUNDIALS ARKODE)
  rk4,       ///< the paper's: classical fourth order, fixed step
};

struct MotionOptions {
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  ///< inertial axes, m/s^2
  Integrator integrator = Integrator::adaptive;
  /// adaptive: the local error of every number y of the state is kept below
  /// about relative_tolerance |y| + absolute_tolerance (SI).
  double relative_tolerance = 1e-9;
  double absolute_tolerance = 1e-10;
  double step = 1e-3;  ///< rk4: step, s
  /// adaptive: longest step, s.
  double longest_step = std::numeric_limits<double>::infinity();
  /// Step limit of one advance_to().
  long step_limit = 100'000'000;
  /// A hinge that begins or ends to rest or slide more often than this within
  /// `stall_span`, s, stops the motion with a failure.
  int stall_changes = 100;
  double stall_span = 1e-6;
  /// A sliding ball joint whose relative speed falls below this slides
  /// straight on until it stops, rad/s (rk4: also from where the next step
  /// would stop it); what is left of the motion across is taken out with the
  /// momentum kept and the energy booked. 0: 100 absolute_tolerance, at least
  /// 1e-9, or rk4: 1e-8.
  double stop_speed = 0;
  /// Set: the carrier moves as prescribed (zero: at rest or uniformly). Not for
  /// a fixed one (Carrier::fixed).
  std::optional<CarrierDrive> carrier_drive;
  CoupledOptions coupling;
};

/// What a hinge does at one time; body axes.
/// Where no friction moments are found that fit, or several are, forces and
/// moments are NaN and there are no joints.
struct HingeSample {
  HingeMode mode;
  /// C: body axes to carrier axes.
  Eigen::Matrix3d rotation;
  Eigen::Vector3d relative_angular_velocity;  ///< exactly 0 at rest, rad/s
  double angle;                               ///< axis only, rad
  double angle_rate;                          ///< axis only, rad/s
  Eigen::Vector3d reaction_force;  ///< R, with the force of friction, N
  /// About the hinge's centre; at rest and locked: all that is held, else
  /// without friction_moment; N m.
  Eigen::Vector3d reaction_moment;
  Eigen::Vector3d friction_moment;  ///< sliding: M_t on the body, N m
  /// resting: tau, the share of what friction can hold that is needed;
  /// sliding with friction: 1; NaN otherwise.
  double utilisation;
  double dissipated;  ///< work of friction since the start, >= 0, J
  /// Of each joint of the hinge, in the order of the node; empty without
  /// friction or if locked or released. At rest: the sliding that is near;
  /// there, and where a ball joint just begins or ends its sliding, power and
  /// slip velocity are those of 1 rad/s.
  std::span<const contact::JointSolution> joints;
};

/// Energies and works since the start, J.
struct EnergyBook {
  double kinetic;
  double gravity;      ///< potential of uniform gravity, 0 at the origin
  double active_work;  ///< done by the force model
  double dissipated;   ///< by all hinges
  /// kinetic + gravity - active_work + dissipated: stays what it was at the
  /// start, while no carrier drive does work.
  double balance() const {
    return kinetic + gravity - active_work + dissipated;
  }
};

/// A change of a hinge.
struct HingeChange {
  double time;
  int body;
  HingeMode from;
  HingeMode to;
};

/// Work so far.
struct MotionCounts {
  long evaluations = 0;  ///< of accelerations
  long steps = 0;
  long outer_iterations = 0;
};

class MotionImpl;

/// The motion at one time, possibly in the middle of a step. Kinematics are
/// there at once; forces are worked out when they are first asked for.
class MotionSample {
 public:
  double time() const;
  /// Carrier, then the bodies.
  std::span<const BodyMotion> motions() const;
  const BodyMotion& carrier() const { return motions()[0]; }
  const BodyMotion& body(int body) const { return motions()[1 + body]; }
  HingeMode mode(int body) const;
  /// Of a body on an axis, rad: cheap, nothing has to be worked out.
  double angle(int body) const;
  /// Works out accelerations and reactions.
  HingeSample hinge(int body) const;
  /// Accelerations of motions()[place]: of the centre of mass, gravity
  /// included, and angular; inertial axes.
  Eigen::Vector3d acceleration(int place) const;
  Eigen::Vector3d angular_acceleration(int place) const;
  EnergyBook energy() const;

 private:
  friend class MotionImpl;
  explicit MotionSample(MotionImpl* motion) : motion_(motion) {}
  MotionImpl* motion_;
};

/// An application's event: a function that crosses 0, continuous between
/// changes of hinges and breaks of the forces. Crossings that come back within
/// a step are found where the function is about a polynomial of degree 6 over
/// it; MotionOptions::longest_step helps where it is not.
struct MotionEvent {
  enum class Crossing { rising, falling, either };
  std::function<double(const MotionSample&)> function;
  Crossing crossing = Crossing::either;
};

/// Why advance_to() came back.
enum class Stop {
  time,    ///< the time asked for
  event,   ///< an application's event
  failed,  ///< Motion::failure() says why
  halted,  ///< at the end of a step, as halt_when() wanted
};

/// How a motion ended that cannot go on.
struct MotionFailure {
  CoupledStatus status;  ///< ok: the integrator gave up
  double time;
  int body;            ///< -1: none in particular
  std::string reason;  ///< "at 0.3 s: ...", without the body
  /// Of several_solutions: the friction moments, link axes.
  std::vector<CoupledSolution> solutions;
  int joint = -1;  ///< of no_contact: which one of the body's hinge

  /// The reason, with body and joint by their numbers.
  std::string message() const;
};

/// All that is needed to go on later: a value.
struct MotionState {
  double time = 0;
  std::vector<double> numbers;
  std::vector<HingeMode> modes;
  std::vector<Eigen::Vector3d> directions;
  std::vector<Eigen::Vector3d> friction;
  std::vector<double> straight_from;  ///< of balls that slide straight, else 0
  /// Of them those that just began: size of their accelerations, else 0.
  std::vector<double> paces;
  std::vector<double> hinge_angles;  ///< as BodyMotion::hinge_angle
  double step = 0;
};

/// A carrier with bodies moving through time.
///
/// All vectors come and go in body axes (system/system.hpp) or inertial axes.
/// The hinges' rest and slip are found on the way: a resting hinge has relative
/// velocity exactly 0 and stays where it is to the last bit.
///
/// Accuracy (README.md of this folder, multibody/motion_test.cpp): stops,
/// onsets of sliding and energies meet closed forms to 1e-9 or the chosen
/// tolerance.
class Motion {
 public:
  /// @param friction  one for each body, or none at all
  /// @param forces    may be null
  /// @throws contact::Error for friction that does not fit the hinge and a
  ///         start that does not fit the system
  Motion(const System& system, std::vector<HingeFriction> friction,
         std::shared_ptr<const ForceModel> forces, const MotionStart& start,
         const MotionOptions& options = {});
  ~Motion();
  Motion(Motion&&) noexcept;
  Motion& operator=(Motion&&) noexcept;

  double time() const;
  /// Moves on to `time`, or to the first event or failure before it. Each
  /// event stops once at each crossing.
  /// @param time  >= time()
  /// @param look  false: sample() is not made that of `time`, which leaves no
  ///   trace: what follows is the same to the last bit as without this stop
  Stop advance_to(double time, bool look = true);
  /// Index of the event that stopped advance_to().
  int event() const;
  /// Set if advance_to(), or anything else that changes the motion, failed.
  /// Motion::restore() brings it back.
  const std::optional<MotionFailure>& failure() const;

  /// At time().
  const MotionSample& sample() const;

  /// From now on, at time(). A released body is a body of its own; a locked
  /// one is held whatever the body on it (its relative velocity is taken out
  /// with the momentum kept, the energy counts as dissipated).
  void release(int body);
  void lock(int body);
  void unlock(int body);
  void set_forces(std::shared_ptr<const ForceModel> forces);

  /// Adds an event; its index.
  int add_event(MotionEvent event);

  /// Calls `look` with the motion at the end of every step that it goes on
  /// from, where forces jump just before and after; not where advance_to()
  /// stops.
  void watch_steps(std::function<void(const MotionSample&)> look);

  /// Asks `halt` before every step; true: advance_to() comes back. It may be
  /// called again.
  void halt_when(std::function<bool()> halt);

  /// Where the step begins that sample() is in, or at whose end it is.
  double step_begin() const;
  /// Length of the last step, s.
  double last_step() const;
  /// The body (as in motions()) whose motion, or whose hinge's, had the largest
  /// error in the last step against the tolerances: what keeps steps short. -1:
  /// the work of the forces, or not known, as with rk4.
  int held_by() const;
  /// Calls `look` with the motion at a time from step_begin() to that of
  /// sample(), by dense output. Also from within watch_steps().
  void look_back(double time,
                 const std::function<void(const MotionSample&)>& look) const;

  /// Sticking, sliding, locking and releasing so far, in order.
  const std::vector<HingeChange>& changes() const;

  /// The beginning of the step that time() is in: another motion that is
  /// restored there comes to time() too, and what is asked of it leaves no
  /// trace here. (Friction is found from what was found before: whoever looks
  /// changes the last bits of what follows.)
  MotionState step_state() const;
  MotionState save() const;
  void restore(const MotionState& state);

  MotionCounts counts() const;

 private:
  std::unique_ptr<MotionImpl> impl_;
};

}  // namespace multibody
