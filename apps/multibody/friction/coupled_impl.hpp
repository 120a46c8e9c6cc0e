#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "multibody/friction/coupled_dynamics.hpp"
#include "multibody/friction/friction_tracker.hpp"
#include "multibody/friction/hinge_solver.hpp"

namespace multibody {

/// The parts of CoupledDynamics: coupled_loop.cpp has the outer loop,
/// coupled_search.cpp what follows where it fails, coupled_rest.cpp rest.
class CoupledDynamics::Impl {
 public:
  Impl(const System& system, std::vector<HingeFriction> friction,
       const CoupledOptions& options);

  // What every evaluation needs comes first, in as few cache lines as can be.
  struct alignas(64) Hinge {
    Hinge(HingeFriction friction, const Link& link, int body)
        : solver(std::move(friction), link, body) {
      has_friction = solver.has_friction();
      can_rest = solver.can_rest();
      is_axis = solver.is_axis();
    }
    HingeMode mode = HingeMode::sliding;
    bool has_friction, can_rest, is_axis;  ///< of the solver
    bool straight = false;
    bool follows = false;
    /// The solver has not seen the last evaluation.
    bool solver_is_behind = false;
    /// m arm/J: |dR/dM| on a fixed carrier.
    double leverage = 0;
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
    /// Beginning to slide: what it could not hold, and where it gave way.
    Eigen::Vector3d excess = Eigen::Vector3d::Zero();
    Eigen::Vector3d first_direction = Eigen::Vector3d::UnitZ();
    double utilisation = 0;
    long utilisation_of = -1;  ///< evaluation that it belongs to
    double mass = 0;
    double length = 0;  ///< of the arms of its hinge
    HingeSolver solver;
  };

  // coupled_dynamics.cpp
  void set_mode(int body, HingeMode mode);
  /// Motion with the present moments.
  void start(const double* state, ActiveForces<double>& forces);
  const CoupledReport& evaluate(const double* state,
                                ActiveForces<double>& forces);
  bool active(const Hinge& hinge) const {
    return hinge.mode == HingeMode::sliding && hinge.has_friction;
  }
  /// Changes the moments by `change_` and follows with the motion.
  void apply_change();
  /// Fills every active hinge's `solved`; the residual.
  /// @param floor  moments below it, times the tolerance, are rounding
  double solve_hinges(double floor = 0);
  /// Ends an evaluation whose friction or utilisation in this hinge is NaN.
  void fail_at(int body);
  /// Worked out when first asked for.
  const Reaction<double>& reaction(int body) {
    know_reactions();
    return reactions_[body];
  }
  void know_reactions() {
    if (!reactions_known_) dynamics.reactions(reactions_);
    reactions_known_ = true;
  }
  /// The joints of a hinge under the reactions found.
  std::span<const contact::JointSolution> joints(int body);
  /// Where the motion comes from says nothing on where it goes.
  void forget_path();
  CoupledRounding noise() const;
  void take_rates(const double* state);
  void list_rows();
  /// Response of a hinge's acceleration and reaction to its own moment.
  struct Response {
    Eigen::Matrix3d acceleration;
    Eigen::Matrix3d force;
    Eigen::Matrix3d moment;
  };
  Response response(int body);
  double kappa(int body);
  double utilisation(int body);
  double slip_limit(int body) const {
    return 1 + (hinges[body].is_axis ? options.slip_threshold
                                     : options.ball_slip_threshold);
  }

  /// What a sliding ball joint feels: its acceleration without friction and
  /// the inertia against which its friction works.
  struct Felt {
    Eigen::Matrix3d inertia;
    Eigen::Vector3d free;
  };
  Felt felt(int body);

  // coupled_search.cpp
  void search();

  // coupled_rest.cpp
  bool any_follows() const;
  const CoupledReport& evaluate_following(const double* state,
                                          ActiveForces<double>& forces);
  const CoupledReport& resolve_rest(const double* state,
                                    ActiveForces<double>& forces, int forced);

  CoupledOptions options;
  Dynamics dynamics;
  FrictionTracker tracker;
  std::vector<Hinge> hinges;
  std::optional<CarrierAcceleration<double>> prescribed;
  CoupledReport report;
  std::vector<OuterStep>* trace = nullptr;
  std::vector<CoupledSolution> solutions;

 private:
  // coupled_loop.cpp
  void extrapolate(const double* state);
  void keep();
  void converge();
  bool track();
  bool track_joints();
  double relax(double enough);
  void learn_contraction(double residual);
  void move();
  void take_reactions();
  void take_applied_moments();
  /// After any other change of moments.
  void forget_applied();
  void loop();
  void update_slopes();
  void set_steps();
  bool converged_is_unique();
  void set_moments(const Eigen::VectorXd& x);
  Eigen::VectorXd moments() const;
  Eigen::VectorXd mismatch(const Eigen::VectorXd& x);
  bool solve_from(Eigen::VectorXd& x);
  std::vector<Eigen::VectorXd> scan_axis();
  std::vector<Eigen::VectorXd> scan_starts(const Eigen::VectorXd& before);
  bool across(const std::vector<int>& balls, const Eigen::MatrixXd& tangents,
              Eigen::VectorXd& parts);
  bool find_directions(const std::vector<int>& begun);
  bool follow_excess(const std::vector<int>& balls);
  bool settle_directions(const std::vector<int>& balls);
  bool driven(int body) const;

  // State of the last evaluation tracked, its move from the one before, that of
  // the present one from it; how many have been kept since the path began.
  Eigen::VectorXd path_end_, path_, step_;
  double path_square_ = 0, step_square_ = 0;  // of their lengths
  int kept_ = 0;
  std::vector<Vec3<double>> change_;
  std::vector<Reaction<double>> reactions_;
  bool reactions_known_ = true;  // none before the first evaluation
  std::vector<int> rows_;        // active hinges
  bool rows_known_ = false;
  long evaluation_ = 0;
  // Whether the tracker's applied moments are those of the hinges; as track()
  // left them the largest, squared, and the largest (leverage |M_t|/|R|)^2,
  // infinity if it is not known.
  bool applied_known_ = false;
  double largest_applied_ = 0;
  double largest_leverage_ = 0;
  double last_residual_ = 0;  // before the last step of relax(); 0: none yet
  double usual_contraction_ = 1;
  double usual_gain_ = 1;  // residual after a step of loop() over that before
  int loops_ = 0;
  int pause_ = 0;  // evaluations until tracking is tried again
  int last_pause_ = 0;
  const double* state_ = nullptr;
  ActiveForces<double>* forces_ = nullptr;
};

}  // namespace multibody
