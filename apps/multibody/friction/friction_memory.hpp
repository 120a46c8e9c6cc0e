#pragma once

#include <Eigen/Core>
#include <vector>

#include "multibody/friction/hinge_solver.hpp"
#include "multibody/friction/tracked_loop.hpp"

namespace multibody {

/// Memory of a hinge, link axes.
struct HingeMemory {
  /// M_t found last.
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  /// Direction of sliding where the state's relative velocity is exactly 0,
  /// and on an axis always: its z is the sign. Unit vector.
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  /// Size of the accelerations by which the direction of a ball joint is
  /// judged that begins to slide, rad/s^2.
  double pace = 1;
  /// Estimate of dM_t(R)/dM_t.
  Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();
  HingeSolver::Memory solver;
};

/// Start of an evaluation of friction: the results of those before it along the
/// motion. A value: an evaluation with a copy leaves no trace.
struct FrictionMemory {
  std::vector<HingeMemory> hinges;
  TrackedLoop tracked;
  /// Residual after a step of the loop without tracking over that before.
  double usual_gain = 1;
  int loops = 0;
  /// Of a deeper tree: Hinges::tree_response(), and where the bodies were.
  double tree_response = 0;
  std::vector<double> response_at = {};

  /// The next evaluation starts from this moment, link axes.
  void set_moment(int body, const Eigen::Vector3d& moment) {
    hinges[body].moment = moment;
    tracked.forget_path();
  }
  /// The hinge does something else.
  void forget(int body) {
    hinges[body].slope.setZero();
    tracked.stop(body);
    usual_gain = 1;
    response_at.clear();
  }
};

}  // namespace multibody
