// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "multibody/friction/coupled_report.hpp"
#include "multibody/friction/hinge_friction.hpp"

/// Records of a motion and of its end.
namespace multibody {

/// A change of a hinge. On stops of ball joints both modes may be the same.
struct HingeChange {
  double time;
  int body;
  HingeMode from;
  HingeMode to;
  /// It rests on a stop; a ball joint turns along it unless friction holds it.
  bool on_stop = false;
};

/// A jump of a hinge's velocity: at a stop, or by a latch. A body that rests on
/// its stop while another one jumps takes part with the rate 0.
struct HingeImpact {
  double time;
  int body;
  bool latches;  ///< by a latch
  /// Rate of the hinge's angle on an axis or at a stop, else |Dw|, before the
  /// jump, rad/s.
  double rate;
  double impulse;  ///< size, N m s
  double loss;     ///< energy loss, J
};

/// Event within a step.
struct StepEvent {
  enum class Kind {
    slip_ends,   ///< sliding about a known direction passes 0
    slows_down,  ///< a ball joint is about to stop: it slides straight on
    speeds_up,   ///< it does not stop
    slip_turns,  ///< it turns against itself within a step
    rest_ends,
    hits_stop,
    settles,      ///< its last bounces on a stop are over
    leaves_stop,  ///< a ball joint's stop would have to pull
    user,         ///< an application's event
  };
  Kind kind;
  int index;  ///< body or event
  double time;
  bool rises = false;  ///< user: direction
};

/// Numbers of operations so far along the motion, without queries.
struct MotionCounts {
  long evaluations = 0;  ///< evaluations of accelerations
  long steps = 0;
  long outer_iterations = 0;
  long unproven = 0;  ///< evaluations with CoupledReport::others_possible
};

/// Failure of a motion that cannot continue.
struct MotionFailure {
  CoupledStatus status;  ///< ok: the integrator gave up
  double time;
  int body;            ///< -1: none in particular
  std::string reason;  ///< "at 0.3 s: ...", without the body
  /// For several_solutions: the friction moments, link axes.
  std::vector<CoupledSolution> solutions;
  int joint = -1;  ///< for no_contact: which joint of the body's hinge

  /// The reason, with body and joint by their numbers.
  std::string message() const;
};

/// Saved state from which a motion continues: a value type.
struct MotionState {
  double time = 0;
  std::vector<double> numbers;
  std::vector<HingeMode> modes;
  std::vector<Eigen::Vector3d> directions;
  std::vector<Eigen::Vector3d> friction;
  std::vector<double> straight_from;  ///< for balls that slide straight, else 0
  /// Size of the acceleration for balls that have just begun to slide, else 0.
  std::vector<double> paces;
  std::vector<double> hinge_angles;  ///< as BodyMotion::hinge_angle
  /// Time at which the unresolved last bounces on a stop end, else 0.
  std::vector<double> settle_times;
  /// Index of the stop on which a ball joint rests, among the body's; else -1.
  std::vector<int> rests_on;
  std::vector<double> losses;  ///< energy loss at stops and latches, J
  double step = 0;
};

}  // namespace multibody
