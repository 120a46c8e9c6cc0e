// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "libcontact/base/error.hpp"

/// Options and report of an evaluation with friction.
namespace multibody {

/// When the outer loop stops.
struct CoupledOptions {
  /// Stop when |M_t - M_t(R)| <= tolerance (|M_t| + |M_t(R)|) for every hinge,
  /// or will certainly hold after the last step.
  double tolerance = 1e-10;
  int iteration_limit = 60;
  /// A resting hinge begins to slide when its utilisation exceeds 1 by this
  /// amount: it is above the rounding of tau, so that a moment exactly at the
  /// limit holds.
  double slip_threshold = 1e-10;
  /// The same for a ball joint: above the uncertainty of its acceleration from
  /// the solved direction of sliding, so that the direction of its motion is
  /// well defined.
  double ball_slip_threshold = 1e-8;
};

/// Outcome of an instant with friction.
enum class CoupledStatus {
  ok,
  /// The outer loop did not converge, and no search decided.
  not_converged,
  /// No friction moments consistent with their reactions were found; on a
  /// single axis none exist.
  no_solution,
  /// Several exist; none is preferred.
  several_solutions,
  /// A number is not finite.
  out_of_range,
  /// A joint's contact has no finite values under its force: its laws end at
  /// lower loads.
  no_contact,
};

/// Friction moments consistent with the reactions that they cause.
struct CoupledSolution {
  /// Moment on each body, link axes, N m; 0 without unknown friction.
  std::vector<Eigen::Vector3d> moments;
};

/// Report of an evaluation.
struct CoupledReport {
  CoupledStatus status = CoupledStatus::ok;
  int iterations = 0;  ///< friction of all hinges, then motion
  /// Largest |M_t - M_t(R)|/(|M_t| + |M_t(R)|), estimated after the last step.
  double residual = 0;
  /// Largest ratio of the changes of M_t(R) to the changes of M_t between two
  /// iterations; at most kappa = |dM/dR||dR/dM| for one hinge.
  double contraction = 0;
  /// ok: the moments are not proven to be the only ones; a search from many
  /// starts, in several hinges at once, found no others.
  bool others_possible = false;
  int body = -1;  ///< body that failed, -1: none in particular
  /// no_contact: the joint of that body's hinge, the status of its contact, and
  /// its force, N.
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
  std::vector<OuterStep>* trace = nullptr;  ///< null: no trace
  void start() { *this = {{}, trace}; }
  void add_step() {
    if (trace) trace->push_back({iterations, residual});
  }
};

}  // namespace multibody
