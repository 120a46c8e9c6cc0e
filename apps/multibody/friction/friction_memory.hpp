#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "multibody/friction/hinge_solver.hpp"
#include "multibody/friction/tracked_loop.hpp"

namespace multibody {

/// Memory of a hinge, link axes.
struct HingeMemory {
  /// Last M_t.
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  /// Direction of sliding if the state's relative velocity is exactly 0, and
  /// always on an axis, where z is the sign. Unit vector.
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  /// Scale of the accelerations in the equation for the direction of a ball
  /// joint that begins to slide, rad/s^2.
  double pace = 1;
  /// Estimate of dM_t(R)/dM_t; in a deeper tree dM_t/dR, m. 0: not known.
  Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();
  HingeSolver::Memory solver;
  /// Steepest chords of M_t over the parts of the reaction, and where: columns
  /// force, moment, rate. See Hinges::chord_kappa().
  struct Chords {
    Eigen::Matrix3d at =
        Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
    double by_force = 0, by_held = 0;
  };
  Chords chords;
};

/// Start of an evaluation of friction: results of earlier evaluations along the
/// motion. A value type: an evaluation with a copy has no side effects.
struct FrictionMemory {
  std::vector<HingeMemory> hinges;
  TrackedLoop tracked;
  /// Residual after a step of the loop without tracking over the residual
  /// before.
  double usual_gain = 1;
  int loops = 0;
  /// Deeper tree only: Hinges::tree_response(), and the bodies' positions for
  /// it.
  double tree_response = 0;
  std::vector<double> response_at = {};

  /// The next evaluation starts from this moment, link axes.
  void set_moment(int body, const Eigen::Vector3d& moment) {
    hinges[body].moment = moment;
    tracked.forget_path();
  }
  /// Call after the mode of the hinge changes.
  void forget(int body) {
    hinges[body].slope.setZero();
    tracked.stop(body);
    usual_gain = 1;
    response_at.clear();
  }
};

}  // namespace multibody
