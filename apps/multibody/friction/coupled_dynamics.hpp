#pragma once

#include <Eigen/Core>
#include <vector>

#include "multibody/friction/hinges.hpp"
#include "multibody/friction/slip_directions.hpp"

namespace multibody {

/// Accelerations, reactions and friction at one instant.
///
/// The friction moments M_i of the sliding hinges depend on the reactions R_i
/// and these on all M_i: M = F(R(M)), the paper's outer loop (section 4). R(M)
/// is affine, and only its changes are computed (Dynamics::add_friction). The
/// joints are tracked by their secant slopes (JointTracker); where
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
///
/// What an evaluation starts from is the memory that it is given: the same
/// state and memory give the same to the last bit, and an evaluation with a
/// copy of the memory leaves no trace.
class CoupledDynamics {
 public:
  /// @param friction  one for each body
  /// @throws contact::Error if friction and kind of hinge do not go together
  CoupledDynamics(const System& system,
                  const std::vector<HingeFriction>& friction,
                  const CoupledOptions& options = {});

  int size() const { return static_cast<int>(hinges_.size()); }
  /// Numbers of a state.
  const StateLayout& layout() const { return layout_; }
  const std::vector<JointMode>& modes() const { return modes_; }
  HingeMode mode(int body) const { return hinge(body).mode; }
  const Hinge& hinge(int body) const { return hinges_[body]; }
  void add_stop(const HingeStop& stop) {
    hinges_[stop.body].stops.push_back(stop);
  }
  /// Whether a body is at a stop, and whether it can rest.
  bool can_push(int body, const double* state) const {
    return hinge(body).push_at(state[layout_.offset(body)]) != 0;
  }
  bool can_rest(int body, const double* state) const {
    return hinge(body).can_rest || can_push(body, state);
  }

  /// Nothing has been found so far.
  const FrictionMemory& beginning() const { return beginning_; }

  /// Resting and locked hinges are held, see Dynamics::set_mode(). The memory
  /// of the motion forgets what the hinge did before.
  void set_mode(int body, HingeMode mode, FrictionMemory& memory);

  /// A ball joint about to stop: its dry friction keeps the direction in
  /// memory, whatever the state says, so that it is smooth through the stop.
  /// Ends with set_mode().
  void slide_straight(int body, bool straight) {
    hinges_[body].straight = straight;
    hinges_[body].follows = false;
  }

  /// A ball joint that has just begun to slide straight: its direction is
  /// found anew in every evaluation, as that in which the joint accelerates, to
  /// HingeMemory::pace. So slow a motion turns there at once. Ends with
  /// slide_straight(). Such evaluations allocate.
  void follow_acceleration(int body) {
    hinges_[body].straight = hinges_[body].follows = true;
  }

  /// @param state  layout().size() numbers
  /// @param at     with forces and a prescribed carrier; takes what is found
  const CoupledReport& evaluate(const double* state, FrictionMemory& memory,
                                Evaluation& at) const;

  /// Decides which of the hinges that are resting hold, and which begin to
  /// slide and where to. Then all is evaluated.
  /// @param due  one is about to slide: half of the threshold beyond what they
  ///   can hold is enough for it, and for those that go with it
  const CoupledReport& resolve_rest(const double* state, FrictionMemory& memory,
                                    Evaluation& at, bool due = false);

  /// All hinges as the last evaluation has left them.
  Hinges at(FrictionMemory& memory, Evaluation& evaluation) const {
    return {hinges_, memory, evaluation};
  }
  // After evaluate():
  /// tau of a resting hinge; NaN where a contact of it has no value. Near 1 the
  /// friction of the others is found to Hinges::refined_tolerance first.
  double utilisation(int body, Hinges at) const;
  /// Utilisation above which a resting hinge begins to slide: by
  /// CoupledOptions::slip_threshold above 1, or by what is uncertain of it.
  double slip_limit(int body, Hinges at) const;
  /// Whether an implicit step of length `step` brings the ball joint of a
  /// sliding hinge to rest: the convex problem of the contact as it is
  /// (contact::MomentSet::prox()) with the inertia that the hinge feels.
  /// @param rate  relative angular velocity, link axes
  static bool stops_within(int body, const Eigen::Vector3d& rate, double step,
                           Hinges at);

 private:
  /// evaluate() in the directions of sliding that there are.
  const CoupledReport& find_friction(const double* state, Hinges& at) const;
  void solve(double tolerance, Hinges& at) const;
  void refine(Hinges& at) const;
  int worst_resting(bool due, Hinges& at) const;
  SlipDirections directions(const double* state, Hinges& at,
                            std::vector<Onset> balls) const;
  bool find_directions(const double* state, Hinges& at,
                       const std::vector<Onset>& begun) const;
  void follow(const double* state, Hinges& at) const;
  Onset begin_to_slide(int body, Hinges& at);

  CoupledOptions options_;
  std::vector<Hinge> hinges_;
  FrictionMemory beginning_;
  std::vector<HingeKind> kinds_;
  std::vector<JointMode> modes_;
  StateLayout layout_;
};

}  // namespace multibody
