#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "multibody/friction/evaluation.hpp"
#include "multibody/friction/friction_memory.hpp"
#include "multibody/friction/hinge_stop.hpp"
#include "multibody/friction/stop_cone.hpp"

namespace multibody {

/// One hinge: constants and mode.
struct Hinge {
  Hinge(HingeFriction friction, const Link& link, int body);

  /// Slides with friction.
  bool is_active() const { return mode == HingeMode::sliding && has_friction; }
  /// The stop that the body is at; a ball joint is at the stop on which it
  /// rests. Null: at none.
  /// @param s  numbers of the body
  const HingeStop* stop_at(const double* s) const;
  /// Sign of the stop's moment; 0: at none.
  int push_at(const double* s) const {
    const HingeStop* stop = stop_at(s);
    return stop ? stop->side : 0;
  }
  /// Turns along its stop.
  bool slides_on_stop() const {
    return rests_on >= 0 && mode == HingeMode::sliding;
  }
  /// Rests on a stop; a ball joint may turn along it.
  bool rests_on_stop(const double* s) const {
    return slides_on_stop() || (mode == HingeMode::resting && push_at(s) != 0);
  }
  /// Distance from one of its stops, rad, and the rate of the stops' angle: see
  /// StopCone for a ball joint, which has stops.
  double gap(const HingeStop& stop, const double* s) const {
    return is_axis ? stop.gap(s[0]) : cone->gap(stop, s);
  }
  double stop_rate(const double* s) const {
    return is_axis ? s[1] : cone->turn(s).rate;
  }

  HingeMode mode = HingeMode::sliding;
  bool straight = false;                 ///< keeps its direction
  bool follows = false;                  ///< slides along its acceleration
  bool has_friction, can_rest, is_axis;  ///< from the solver
  /// m arm/J: |dR/dM| on a fixed carrier.
  double leverage;
  double mass;
  double inertia;  ///< least about the hinge, for turns of the body
  double length;   ///< sum of the arms of this hinge and its ancestors
  HingeSolver solver;
  std::vector<HingeStop> stops;
  std::optional<StopCone> cone;  ///< a ball joint's, if it has stops
  int rests_on = -1;  ///< ball joint: index of the stop on which it rests
};

/// Mode of a hinge in the dynamics.
JointMode joint_mode(HingeMode mode);

/// @throws contact::Error if friction does not suit the kind of hinge
std::vector<Hinge> make_hinges(const System& system,
                               const std::vector<HingeFriction>& friction);

/// All hinges at one instant: given friction moments, and the resulting motion
/// and reactions. Does not check that the moments match the reactions: see
/// CoupledDynamics.
class Hinges {
 public:
  /// This fraction of the largest moment in the system is the least scale of
  /// every hinge's moment: smaller moments vanish in the rounding of the
  /// reactions.
  static constexpr double small_share = 1e-3;
  /// Tolerance of moments of the highest accuracy, the tolerance of the joints'
  /// own solutions.
  static constexpr double refined_tolerance = 1e-12;

  /// Keeps references to all arguments.
  Hinges(const std::vector<Hinge>& hinges, FrictionMemory& memory,
         Evaluation& evaluation)
      : hinges_(hinges), memory_(memory), at_(evaluation) {}

  int size() const { return static_cast<int>(hinges_.size()); }
  const Hinge& operator[](int body) const { return hinges_[body]; }
  FrictionMemory& memory() const { return memory_; }
  HingeMemory& memory(int body) const { return memory_.hinges[body]; }
  HingeInstant& now(int body) const { return at_.hinges[body]; }
  Evaluation& evaluation() const { return at_; }
  CoupledProgress& report() const { return at_.report; }
  ActiveForces<double>& forces() const { return at_.forces; }
  /// Hinges that slide with friction since the last set_state().
  const std::vector<int>& active() const { return at_.active; }
  bool is_prescribed() const { return at_.prescribed.has_value(); }
  bool is_tree() const { return at_.dynamics.is_tree(); }
  /// Whether a hinge has just begun to slide: its acceleration is caused only
  /// by the small excess over its friction.
  bool any_gets_under_way() const;

  /// Sets a new instant: rates of the active hinges. `state` may be the state
  /// of the evaluation.
  void set_state(const double* state);
  /// Computes the motion with the present moments, which forces() then
  /// contains.
  void start();
  /// Pending change of a hinge's moment.
  Vec3<double>& change(int body) { return at_.change[body]; }
  void apply_changes();

  /// Tracked joints: they receive the reactions, and their changes move the
  /// bodies.
  void give_reactions(FrictionTracker& tracker);
  void take_moment(int body, const Eigen::Vector3d& moment);
  void move(FrictionTracker& tracker);

  /// Reactions, computed on first use.
  const Reaction<double>& reaction(int body) {
    know_reactions();
    return at_.reactions[body];
  }
  Eigen::Vector3d acceleration(int body) const;  ///< relative, rad/s^2
  /// Computes `solved` of every active hinge.
  /// @param floor  moments below this, times the tolerance, are rounding
  /// @return largest relative difference of `solved` and `moment`
  double solve(double floor = 0);
  /// Solves the joints of a hinge under the present reactions.
  std::span<const contact::JointSolution> joints(int body);
  /// Utilisation: 0 on an axis with a pressing stop; infinite if an ideal hinge
  /// would leave it.
  double utilisation(int body);
  /// Moment with which the stop that the body is at presses on it, N m; below 0
  /// if it had to pull. 0 without one.
  double stop_moment(int body);
  /// Null where it does not turn along its stop.
  const ConeRest* cone_of(int body) const;
  /// n of StopCone.
  Eigen::Vector3d cone_axis(int body) const;
  CoupledRounding rounding() const;
  /// Upper estimate of the error of the moment that a hinge holds, with
  /// friction solved to refined_tolerance, N m.
  double uncertain_moment() const;
  double kappa(int body);
  /// A bound of the spectral radius of K, with K_ij = |dR_i/dM_j| times the
  /// steepest chord of M_i over R_i. Below 1 the moments are unique.
  /// Allocates.
  /// @param forces  responses() of forces if known, else empty
  double chord_kappa(Eigen::MatrixXd forces = {});
  /// Largest row sum of |dR_i/dM_j|, 1/m, recomputed when the bodies have
  /// moved noticeably.
  /// @param to  |dR_i/dM_j| if they are computed
  double tree_response(Eigen::MatrixXd& to);
  /// Deeper tree only: Newton steps of all hinges at once, stored as pending
  /// changes. Call after solve().
  /// @param fresh  computes the slopes anew; else remembered ones may serve
  void set_tree_steps(bool fresh);

  /// Effective inertia of a sliding ball joint, and its acceleration without
  /// friction.
  struct Felt {
    Eigen::Matrix3d inertia;
    Eigen::Vector3d free;
  };
  Felt felt(int body);

 private:
  /// Response of a hinge's acceleration and reaction to its own moment.
  struct Response {
    Eigen::Matrix3d acceleration, force, moment;
  };
  Response response(int body);
  Eigen::MatrixXd responses(Vec3<double> Reaction<double>::*part);
  double chord(int body, Vec3<double> Reaction<double>::*part);
  const HingeMemory::Chords& chords(int body);
  /// Slopes of a hinge's friction over its reaction.
  struct Slopes {
    Eigen::Matrix3d by_force, by_held;
  };
  Slopes slopes(int body);
  void evaluate();
  void add_moments(const std::vector<Vec3<double>>& changes);
  void add_cone(int body, const double* s);
  void find_cone_inertia();
  Eigen::VectorXd along_cones() const;
  void push(const Eigen::VectorXd& by);
  void keep_on_cones();
  void add_stop(int body);
  double work_out_utilisation(int body);
  double utilisation_on_cone(int body);
  void know_reactions();

  const std::vector<Hinge>& hinges_;
  FrictionMemory& memory_;
  Evaluation& at_;
};

}  // namespace multibody
