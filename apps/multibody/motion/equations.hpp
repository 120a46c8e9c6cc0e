#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "multibody/friction/coupled_dynamics.hpp"
#include "multibody/motion/motion_options.hpp"
#include "multibody/system/kinematics.hpp"

namespace multibody {

/// Equations of motion: d(state)/dt.
///
/// Numbers of a state: those of StateLayout; for each body the work that
/// friction took; the work of the force model; for each body the integral of
/// what a held hinge transmits, in units of its first value. The last are
/// there for the error control alone: while hinges rest nothing else in the
/// state tells it how fast the forces change that may end the rest.
class Equations {
 public:
  /// As Motion::Motion().
  Equations(const System& system, std::vector<HingeFriction> friction,
            std::shared_ptr<const ForceModel> forces,
            const MotionOptions& options);

  int size() const { return system.size(); }
  bool is_axis(int body) const {
    return hinge_traits(system.links()[body].kind).is_axis;
  }
  const std::vector<JointMode>& modes() const {
    return coupled.dynamics().modes();
  }
  int offset(int body) const { return coupled.layout().offset(body); }
  int dissipated_at(int body) const { return coupled.layout().size() + body; }
  int work_at() const { return dissipated_at(size()); }
  int held_at(int body) const { return work_at() + 1 + body; }
  int number_count() const { return held_at(size()); }
  /// Body (1 +) or carrier (0) that a number of the state belongs to; -1: none.
  int owner_of(int number) const;
  /// Relative angular velocity, link axes.
  Eigen::Vector3d rate_of(int body, const double* state) const {
    return relative_rate(system.links()[body], state + offset(body));
  }

  /// @return false if friction is not found, see failed_report
  bool rates(double time, const double* state, double* to);
  /// The same in a step, which sees the forces before the next break.
  bool rates_in_step(double time, const double* state, double* to);
  /// @param model  may be null
  void set_forces(std::shared_ptr<const ForceModel> model);
  /// Makes what hinges hold now the unit of the numbers for it.
  void set_held_units();
  /// For when the body is released.
  void keep_hinge_angle(int body, double angle) {
    motions_[1 + body].hinge_angle = angle;
  }

  const System system;
  const Eigen::Vector3d gravity;
  const std::optional<CarrierDrive> drive;
  CoupledDynamics coupled;
  std::shared_ptr<const ForceModel> forces;
  double next_break = std::numeric_limits<double>::infinity();
  ActiveForces<double> active;  ///< of the last evaluation
  long evaluations = 0;
  long outer_iterations = 0;
  CoupledReport failed_report;  ///< of the last that failed
  double failed_time = 0;

 private:
  double held_rate(int body) const;

  struct Unit {
    double force = 1;
    double moment = 1;
  };
  std::vector<Unit> held_units_;
  std::vector<BodyForce> body_forces_;
  std::vector<BodyMotion> motions_;
};

}  // namespace multibody
