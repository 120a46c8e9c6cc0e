#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "multibody/dynamics/dynamics.hpp"
#include "multibody/friction/coupled_report.hpp"

namespace multibody {

/// One hinge at one instant, link axes.
struct HingeInstant {
  Eigen::Vector3d rate = Eigen::Vector3d::Zero();
  /// M_t(R) for the moment of the computed motion.
  Eigen::Vector3d solved = Eigen::Vector3d::Zero();
  Eigen::Vector3d last_moment, last_solved;  ///< previous step of the loop
  /// The joints' solutions belong to an earlier evaluation.
  bool solver_is_behind = false;
  int push = 0;  ///< Hinge::push_at() of a held hinge
  double utilisation = 0;
  /// Resting ball joint: moment of its stop, in the split of this utilisation.
  double stop_moment = 0;
  long utilisation_of = -1;  ///< Evaluation::number that it belongs to
};

/// A ball joint that turns along its stop.
struct ConeRest {
  int body;
  int side;              ///< of the stop
  Eigen::Vector3d axis;  ///< n of StopCone, link axes
  double target;         ///< n.w' for which psi'' = 0, rad/s^2
  double moment = 0;     ///< of the stop on the body about n, N m
};

/// One instant with friction: input and results of an evaluation. The next
/// evaluation reuses only the allocated memory.
struct Evaluation {
  explicit Evaluation(const System& system);

  /// The state evaluated.
  std::vector<double> state;
  /// Input; friction moments are results.
  ActiveForces<double> forces;
  /// The carrier's accelerations: input, or (nullopt) a result.
  std::optional<CarrierAcceleration<double>> prescribed;

  Dynamics dynamics;
  CoupledProgress report;
  /// Solutions of a search; empty without a search.
  std::vector<CoupledSolution> solutions;

  // Members below are for Hinges.
  std::vector<HingeInstant> hinges;
  std::vector<int> active;           ///< hinges that slide with friction
  std::vector<Vec3<double>> change;  ///< pending changes of moments
  std::vector<Reaction<double>> reactions;
  std::vector<Eigen::Matrix3d>
      slopes;                   ///< dM/dR of the active hinges of a tree
  bool reactions_known = true;  ///< none before the first evaluation
  bool is_refined = false;      ///< to Hinges::refined_tolerance
  long number = 0;              ///< counts the sets of moments
  std::vector<ConeRest> cones;
  /// Moments about n over changes of n.w' of these.
  Eigen::MatrixXd cone_inertia;
  std::vector<Vec3<double>> cone_change;  ///< moments of stops, one per body
};

}  // namespace multibody
