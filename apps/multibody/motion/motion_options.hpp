// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <vector>

#include "multibody/friction/coupled_report.hpp"
#include "multibody/friction/hinge_stop.hpp"
#include "multibody/system/force_model.hpp"

/// Start and time integration of a motion.
namespace multibody {

/// Position and velocity of a body at the start.
struct BodyStart {
  /// ball: C, body axes to carrier axes, and the relative angular
  /// velocity, body axes. Exactly 0: the hinge begins at rest if its
  /// friction holds it.
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d relative_angular_velocity = Eigen::Vector3d::Zero();
  double angle = 0;       ///< axis, rad
  double angle_rate = 0;  ///< axis, rad/s; 0 as above
  /// A locked hinge does not move until unlock(); its rate must be 0.
  bool locked = false;
  /// For a body without a hinge.
  BodyMotion body{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                  Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()};
};

/// State of the whole system at the start.
struct MotionStart {
  double time = 0;  ///< s
  BodyMotion carrier{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                     Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()};
  std::vector<BodyStart> bodies;  ///< one for each body
};

/// Prescribed motion of the carrier.
struct CarrierDrive {
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  ///< inertial axes
  Eigen::Vector3d angular_acceleration = Eigen::Vector3d::Zero();  ///< carrier
};

/// Time integrators.
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
  /// The motion fails if a hinge changes between rest and slip more often than
  /// this within `stall_span`, s.
  int stall_changes = 100;
  double stall_span = 1e-6;
  /// A sliding ball joint whose relative speed falls below this slides straight
  /// until it stops, rad/s (rk4: also if the next step would stop it). The
  /// remaining motion across is removed; momentum is conserved and the energy
  /// recorded. 0: 100 absolute_tolerance, at least 1e-9, or rk4: 1e-8.
  double stop_speed = 0;
  /// Set: the carrier moves as prescribed (zero: at rest or uniformly). Not for
  /// a fixed carrier (Carrier::fixed).
  std::optional<CarrierDrive> carrier_drive;
  CoupledOptions coupling;
  /// Rigid stops of bodies, at most one on each side of a body.
  std::vector<HingeStop> stops;
};

}  // namespace multibody
