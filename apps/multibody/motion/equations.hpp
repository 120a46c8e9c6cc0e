#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <vector>

#include "multibody/friction/coupled_dynamics.hpp"
#include "multibody/motion/motion_options.hpp"
#include "multibody/system/kinematics.hpp"

namespace multibody {

/// One instant of a motion: positions, and the results of an evaluation.
struct MotionInstant {
  explicit MotionInstant(const System& system)
      : bodies(1 + system.size()),
        forces(1 + system.size()),
        friction(system) {}

  std::vector<BodyMotion> bodies;  ///< carrier, then the bodies
  std::vector<BodyForce> forces;
  std::vector<BodyMass> masses;  ///< changing masses
  Evaluation friction;
};

/// Equations of motion: d(state)/dt.
///
/// Numbers of a state: the numbers of StateLayout; for each body the energy
/// dissipated by friction; the work of the force model; for each body the
/// integral of the load of a held hinge, in units of its first value. The last
/// serve only the error control: while hinges rest no other number shows how
/// fast the forces change that may end the rest.
class Equations {
 public:
  /// Arguments as in Motion::Motion().
  Equations(const System& system, std::vector<HingeFriction> friction,
            std::shared_ptr<const ForceModel> forces,
            const MotionOptions& options);

  int size() const { return system.size(); }
  bool is_axis(int body) const {
    return hinge_traits(system.links()[body].kind).is_axis;
  }
  const std::vector<JointMode>& modes() const { return coupled.modes(); }
  int offset(int body) const { return coupled.layout().offset(body); }
  int dissipated_at(int body) const { return coupled.layout().size() + body; }
  int work_at() const { return dissipated_at(size()); }
  int held_at(int body) const { return work_at() + 1 + body; }
  int number_count() const { return held_at(size()); }
  /// Body (1 +) or carrier (0) of a number of the state; -1: none.
  int owner_of(int number) const;
  /// Relative angular velocity, link axes.
  Eigen::Vector3d rate_of(int body, const double* state) const {
    return relative_rate(system.links()[body], state + offset(body));
  }

  /// @param at  receives the results; friction.report gives a reason for
  ///            failure
  /// @return false if friction cannot be computed
  bool rates(double time, const double* state, FrictionMemory& from,
             MotionInstant& at, double* to) const;
  /// As above, in a step, with the forces before the next break and the memory
  /// of the motion.
  bool rates_in_step(double time, const double* state, double* to);
  /// As above, with a copy of the memory: no side effects.
  bool rates_aside(double time, const double* state, double* to);
  /// Decides which hinges hold, see CoupledDynamics::resolve_rest().
  CoupledReport resolve_rest(double time, const double* state, bool due);
  /// Restarts, including the integrals of the loads of held hinges.
  void begin_at(double time, const double* state);
  /// Masses that change, as they are at a time.
  void set_masses(double time, std::vector<BodyMass>& masses,
                  Dynamics& dynamics) const;
  /// The next break after a time.
  double break_after(double time) const;
  /// Changes the mode of a hinge.
  void set_mode(int body, HingeMode mode) {
    coupled.set_mode(body, mode, memory);
  }
  /// Last evaluation in a step or in resolve_rest().
  const Evaluation& last() const { return here_.friction; }
  /// Keeps the angle when the body is released.
  void keep_hinge_angle(int body, double angle) {
    here_.bodies[1 + body].hinge_angle = angle;
  }

  /// Energy dissipated by stops and latches in each body's hinge, J.
  std::vector<double> losses;
  const System system;
  const Eigen::Vector3d gravity;
  const std::optional<CarrierDrive> drive;
  CoupledDynamics coupled;
  FrictionMemory memory;                     ///< along the motion
  std::shared_ptr<const ForceModel> forces;  ///< may be null
  double next_break = std::numeric_limits<double>::infinity();
  long evaluations = 0;  ///< along the motion
  long outer_iterations = 0;
  long unproven = 0;            // friction found by evaluations
  CoupledReport failed_report;  ///< the last that failed
  double failed_time = 0;

 private:
  double before_break(double time) const;
  double held_rate(int body, Hinges& at) const;
  void set_held_units();

  struct Unit {
    double force = 1;
    double moment = 1;
  };
  std::vector<Unit> held_units_;
  MotionInstant here_;
  FrictionMemory aside_;
};

}  // namespace multibody
