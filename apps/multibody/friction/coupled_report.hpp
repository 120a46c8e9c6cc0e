#pragma once

#include <Eigen/Core>
#include <vector>

#include "libcontact/base/error.hpp"

/// Options and report of an evaluation with friction.
namespace multibody {

/// When the outer loop stops.
struct CoupledOptions {
  /// Stop when every hinge's |M_t - M_t(R)| <= tolerance (|M_t| + |M_t(R)|),
  /// or is sure to be after the step that has been made.
  double tolerance = 1e-10;
  int iteration_limit = 60;
  /// A resting hinge begins to slide when its utilisation exceeds 1 by this:
  /// above the rounding of tau, so that a moment right at the limit holds.
  double slip_threshold = 1e-10;
  /// The same of a ball joint: above what the direction found for its sliding
  /// leaves uncertain of its acceleration, so that it is clear where it goes.
  double ball_slip_threshold = 1e-8;
};

/// How an instant with friction came out.
enum class CoupledStatus {
  ok,
  /// The outer loop did not get there, and no search settled the matter.
  not_converged,
  /// No friction moments were found that fit the reactions they cause; on a
  /// single axis there are none.
  no_solution,
  /// There are several; none is preferred.
  several_solutions,
  /// A number is not finite.
  out_of_range,
  /// A joint's contact has no finite values under the force on it: its laws
  /// end below.
  no_contact,
};

/// Friction moments that fit the reactions they cause.
struct CoupledSolution {
  /// Moment of each body, link axes, N m; 0 where no friction is looked for.
  std::vector<Eigen::Vector3d> moments;
};

/// How an evaluation went.
struct CoupledReport {
  CoupledStatus status = CoupledStatus::ok;
  int iterations = 0;  ///< friction of all hinges, then motion
  /// Largest |M_t - M_t(R)|/(|M_t| + |M_t(R)|), after the last step as it is
  /// expected.
  double residual = 0;
  /// Largest ratio of the changes of M_t(R) to those of M_t between two
  /// iterations; at most kappa = |dM/dR||dR/dM| on one hinge.
  double contraction = 0;
  /// ok: the moments are not proven to be the only ones; a search from many
  /// starts, in several hinges at once, found no others.
  bool others_possible = false;
  int body = -1;  ///< body that failed, -1: none in particular
  /// no_contact: which joint of that body's hinge, what came of its contact,
  /// and the force on it, N.
  int joint = -1;
  contact::Status contact = contact::Status::ok;
  double force = 0;
};

/// Effect of rounding on reactions that cancel: an upper estimate.
struct CoupledRounding {
  double force;   ///< N
  double moment;  ///< N m
};

/// A step of the outer loop.
struct OuterStep {
  int iteration;
  double residual;
};

/// Report of an evaluation in progress.
struct CoupledProgress : CoupledReport {
  std::vector<OuterStep>* trace = nullptr;  ///< null: none is wanted
  void start() { *this = {{}, trace}; }
  void add_step() {
    if (trace) trace->push_back({iterations, residual});
  }
};

}  // namespace multibody
