#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "multibody/friction/hinges.hpp"
#include "multibody/friction/slip_directions.hpp"
#include "multibody/friction/tracked_loop.hpp"

namespace multibody {

/// Accelerations, reactions and friction at one instant.
///
/// The friction moments M_i of the sliding hinges depend on the reactions R_i
/// and these on all M_i: M = F(R(M)), the paper's outer loop (section 4). R(M)
/// is affine, and only its changes are computed (Dynamics::add_friction). The
/// joints are tracked by their secant slopes (contact::JointTracker); where
/// that is not safe they are solved, each hinge with Newton steps and a secant
/// slope. Where that fails, or kappa >= 1 allows several solutions or none
/// (Painleve), all solutions are looked for and the report says how many there
/// are.
///
/// Friction moments are those of the joints alone under the reactions found,
/// to 1e-9 (measured 2e-10, multibody/coupled_dynamics_test.cpp).
///
/// Everything is in link axes (Link::axes), as in Dynamics; friction
/// solutions in body axes. No evaluation allocates unless the search
/// is needed.
class CoupledDynamics {
 public:
  /// @param friction  one for each body
  /// @throws contact::Error if friction and kind of hinge do not go together
  CoupledDynamics(const System& system,
                  const std::vector<HingeFriction>& friction,
                  const CoupledOptions& options = {});

  int size() const { return hinges_->size(); }
  const Dynamics& dynamics() const { return hinges_->dynamics(); }
  const StateLayout& layout() const { return dynamics().layout(); }
  HingeMode mode(int body) const { return hinge(body).mode; }
  /// Resting and locked hinges are held, see Dynamics::set_mode().
  void set_mode(int body, HingeMode mode);
  /// What is known of it.
  const Hinge& hinge(int body) const { return (*hinges_)[body]; }

  /// Direction of sliding where the state's relative velocity is exactly 0,
  /// and on an axis always: its z is the sign. Unit vector, link axes.
  void set_direction(int body, const Eigen::Vector3d& direction) {
    at(body).direction = direction;
  }
  const Eigen::Vector3d& direction(int body) const {
    return hinge(body).direction;
  }

  /// A ball joint about to stop: its dry friction keeps its direction(),
  /// whatever the state says, so that it is smooth through the stop. Ends
  /// with set_mode().
  void slide_straight(int body, bool straight) {
    at(body).straight = straight;
    at(body).follows = false;
  }

  /// A ball joint that has just begun to slide straight: its direction() is
  /// found anew in every evaluation, as that in which the joint accelerates.
  /// So slow a motion turns there at once. Ends with slide_straight(). Such
  /// evaluations allocate.
  /// @param pace  size of the accelerations by which its direction is judged,
  ///   rad/s^2, as resolve_rest() has found it (Hinge::pace)
  void follow_acceleration(int body, double pace) {
    at(body).straight = at(body).follows = true;
    at(body).pace = pace;
  }

  /// The carrier's accelerations are given, or (nullopt) result.
  void prescribe_carrier(
      const std::optional<CarrierAcceleration<double>>& carrier) {
    hinges_->prescribe_carrier(carrier);
  }

  /// State and forces have to stay where they are until the next evaluation:
  /// what is asked for after this one may look at them.
  /// @param state    layout().size() numbers
  /// @param forces  its friction moments are replaced by those found
  const CoupledReport& evaluate(const double* state,
                                ActiveForces<double>& forces);
  const CoupledReport& report() const { return report_; }
  /// Records the steps of the next evaluations; null: no longer.
  void set_trace(std::vector<OuterStep>* trace) { report_.trace = trace; }

  /// After evaluate().
  const Eigen::Vector3d& friction_moment(int body) const {
    return hinge(body).moment;
  }
  /// Where the next evaluation starts from.
  void set_friction_moment(int body, const Eigen::Vector3d& moment) {
    at(body).moment = moment;
    tracked_.forget_path();
  }
  const Reaction<double>& reaction(int body) const {
    return hinges_->reaction(body);
  }
  /// tau of a resting hinge; NaN where a contact of it has no value. Near 1 the
  /// friction of the others is found to Hinges::refined_tolerance first.
  double utilisation(int body);
  /// Utilisation above which a resting hinge begins to slide: by
  /// CoupledOptions::slip_threshold above 1, or by what is uncertain of it.
  double slip_limit(int body);
  std::span<const contact::JointSolution> joints(int body) const {
    return hinges_->joints(body);
  }

  /// What the search of the last evaluation found; empty if there was none.
  std::span<const CoupledSolution> solutions() const { return solutions_; }

  /// Decides which of the hinges that are resting hold, and which begin to
  /// slide and where to. Then all is evaluated.
  /// @param due  one is about to slide: half of the threshold beyond what they
  ///   can hold is enough for it, and for those that go with it
  const CoupledReport& resolve_rest(const double* state,
                                    ActiveForces<double>& forces,
                                    bool due = false);

  /// Of the last evaluation. Reactions below it are taken for 0 where rest is
  /// decided.
  CoupledRounding rounding() const { return hinges_->rounding(); }

  /// After evaluate(): whether an implicit step of length `step` brings the
  /// ball joint of a sliding hinge to rest: the convex problem of the contact
  /// as it is (contact::MomentSet::prox()) with the inertia that the hinge
  /// feels.
  /// @param rate  relative angular velocity, link axes
  bool stops_within(int body, const Eigen::Vector3d& rate, double step);

  /// kappa_i = |dM_i/dR_i||dR_i/dM_i| of a sliding hinge, after evaluate().
  double kappa(int body) { return hinges_->kappa(body); }

 private:
  Hinge& at(int body) { return (*hinges_)[body]; }

  /// evaluate() in the directions of sliding that there are.
  const CoupledReport& find_friction(const double* state,
                                     ActiveForces<double>& forces);
  void solve(double tolerance);
  void refine();
  int worst_resting(bool due);
  void update_slopes();
  void set_steps();
  bool is_unique();
  void fail_at(int body);
  SlipDirections directions(const double* state, ActiveForces<double>& forces,
                            std::vector<Onset> balls);
  bool find_directions(const double* state, ActiveForces<double>& forces,
                       const std::vector<Onset>& begun);
  const CoupledReport& follow(const double* state,
                              ActiveForces<double>& forces);
  Onset begin_to_slide(int body);

  std::unique_ptr<Hinges> hinges_;  // stays where it is: tracked_ refers to it
  CoupledOptions options_;
  CoupledProgress report_;
  std::vector<CoupledSolution> solutions_;
  TrackedLoop tracked_;
  bool is_refined_ = false;  // the last evaluation is
  double usual_gain_ = 1;  // residual after a step of solve() over that before
  int loops_ = 0;
};

}  // namespace multibody
