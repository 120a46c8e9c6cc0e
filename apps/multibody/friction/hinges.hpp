#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "multibody/dynamics/dynamics.hpp"
#include "multibody/friction/coupled_report.hpp"
#include "multibody/friction/friction_tracker.hpp"
#include "multibody/friction/hinge_solver.hpp"

namespace multibody {

/// One hinge at the present instant, link axes. What every evaluation needs
/// comes first, in as few cache lines as can be.
struct alignas(64) Hinge {
  Hinge(HingeFriction friction, const Link& link, int body);

  /// Slides with friction.
  bool is_active() const { return mode == HingeMode::sliding && has_friction; }

  HingeMode mode = HingeMode::sliding;
  bool has_friction, can_rest, is_axis;  ///< of the solver
  bool straight = false;                 ///< keeps its direction
  bool follows = false;  ///< its direction is that of its acceleration
  /// The solver has not seen the last evaluation.
  bool solver_is_behind = false;
  /// m arm/J: |dR/dM| on a fixed carrier.
  double leverage;
  /// M_t that the motion has been worked out with, and M_t(R) for it.
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  Eigen::Vector3d solved = Eigen::Vector3d::Zero();
  Eigen::Vector3d rate = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  /// Estimate of d(solved)/d(moment), kept from evaluation to evaluation.
  Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();
  Eigen::Vector3d last_moment, last_solved;
  /// Beginning to slide: size of its accelerations.
  double pace = 1;
  double utilisation = 0;
  long utilisation_of = -1;  ///< evaluation that it belongs to
  double mass;
  double inertia;  ///< least about the hinge of a turn that moves the body
  double length;   ///< of the arms of its hinge
  HingeSolver solver;
};

/// All hinges at one instant: the friction moments that they are given, and
/// the motion and the reactions that follow from them. Whether the moments fit
/// the reactions is for others to say (Coupling).
class Hinges {
 public:
  /// A part of this size of the largest moment in the system counts as scale
  /// of every hinge's moment: smaller ones vanish in the rounding of the
  /// reactions.
  static constexpr double small_share = 1e-3;
  /// Tolerance of moments that are to be as good as they can be: that of the
  /// joints' own solutions.
  static constexpr double refined_tolerance = 1e-12;

  /// @param friction  one for each body
  /// @throws contact::Error if friction and kind of hinge do not go together
  Hinges(const System& system, const std::vector<HingeFriction>& friction);

  int size() const { return static_cast<int>(hinges_.size()); }
  Hinge& operator[](int body) { return hinges_[body]; }
  const Hinge& operator[](int body) const { return hinges_[body]; }
  const Dynamics& dynamics() const { return dynamics_; }
  bool any_follows() const {
    return std::ranges::any_of(hinges_, &Hinge::follows);
  }
  /// Whether a hinge has hardly begun to slide: its acceleration is what its
  /// friction is short of, next to nothing.
  bool any_gets_under_way() const;
  /// Which hinges slide with friction, as of the last set_state().
  const std::vector<int>& active() const { return active_; }
  void set_mode(int body, HingeMode mode);
  void prescribe_carrier(
      const std::optional<CarrierAcceleration<double>>& carrier) {
    prescribed_ = carrier;
  }

  /// A new instant: rates of the active hinges. The state has to stay where it
  /// is.
  void set_state(const double* state);
  /// The motion with the present moments, which are entered in `forces`. They
  /// have to stay where they are too.
  void start(ActiveForces<double>& forces);
  /// By which the moment of a hinge is about to change.
  Vec3<double>& change(int body) { return change_[body]; }
  void apply_changes();
  /// So often moments have been changed here.
  long change_count() const { return change_count_; }

  /// Joints that are tracked: they get the reactions, and what they change
  /// moves the bodies.
  void give_reactions(FrictionTracker& tracker);
  void take_moment(int body, const Eigen::Vector3d& moment);
  void move(FrictionTracker& tracker);
  bool is_prescribed() const { return prescribed_.has_value(); }

  /// Worked out when first asked for.
  const Reaction<double>& reaction(int body) {
    know_reactions();
    return reactions_[body];
  }
  Eigen::Vector3d acceleration(int body) const;  ///< relative, rad/s^2
  /// Fills every active hinge's `solved`.
  /// @param floor  moments below it, times the tolerance, are rounding
  /// @return largest of the relative differences of `solved` and `moment`
  double solve(double floor = 0);
  /// The joints of a hinge under the reactions found.
  std::span<const contact::JointSolution> joints(int body);
  double utilisation(int body);
  CoupledRounding rounding() const;
  /// By which what a hinge holds may be wrong where friction is found to
  /// refined_tolerance, N m: an upper estimate.
  double uncertain_moment() const;
  double kappa(int body);

  /// What a sliding ball joint feels: the inertia against which its friction
  /// works and its acceleration without friction.
  struct Felt {
    Eigen::Matrix3d inertia;
    Eigen::Vector3d free;
  };
  Felt felt(int body);

 private:
  /// Of a hinge's acceleration and reaction to its own moment.
  struct Response {
    Eigen::Matrix3d acceleration, force, moment;
  };
  Response response(int body);
  void evaluate();
  void know_reactions();

  Dynamics dynamics_;
  std::vector<Hinge> hinges_;
  std::optional<CarrierAcceleration<double>> prescribed_;
  std::vector<Vec3<double>> change_;
  long change_count_ = 0;
  std::vector<Reaction<double>> reactions_;
  bool reactions_known_ = true;  // none before the first evaluation
  std::vector<int> active_;
  bool active_known_ = false;
  long evaluation_ = 0;
  const double* state_ = nullptr;
  ActiveForces<double>* forces_ = nullptr;
};

}  // namespace multibody
