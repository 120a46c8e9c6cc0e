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
/// joints are tracked by their secant slopes (JointTracker). If tracking is not
/// safe they are solved, each hinge with Newton steps and a secant slope. If
/// this fails, or kappa >= 1 allows several solutions or none (Painleve), a
/// search looks for all solutions and the report counts them.
///
/// Friction moments equal the moments of the single joints under the resulting
/// reactions, to 1e-9 (measured 2e-10, multibody/coupled_dynamics_test.cpp).
///
/// All vectors are in link axes (Link::axes), as in Dynamics; friction
/// solutions are in body axes. Evaluations allocate only if the search is
/// needed, or where ball joints turn along their stops.
///
/// An evaluation starts from the given memory: the same state and memory give
/// bit-identical results, and an evaluation with a copy of the memory has no
/// side effects.
class CoupledDynamics {
 public:
  /// @param friction  one for each body
  /// @throws contact::Error if friction does not suit the kind of hinge
  CoupledDynamics(const System& system,
                  const std::vector<HingeFriction>& friction,
                  const CoupledOptions& options = {});

  int size() const { return static_cast<int>(hinges_.size()); }
  /// Layout of a state.
  const StateLayout& layout() const { return layout_; }
  const std::vector<JointMode>& modes() const { return modes_; }
  HingeMode mode(int body) const { return hinge(body).mode; }
  const Hinge& hinge(int body) const { return hinges_[body]; }
  /// @param link  of its body
  void add_stop(const HingeStop& stop, const Link& link) {
    Hinge& hinge = hinges_[stop.body];
    hinge.stops.push_back(stop);
    if (!hinge.is_axis) hinge.cone.emplace(stop, link);
  }
  /// Whether a body is at a stop, and whether it can rest.
  bool can_push(int body, const double* state) const {
    return hinge(body).push_at(state + layout_.offset(body)) != 0;
  }
  bool can_rest(int body, const double* state) const {
    return hinge(body).can_rest ||
           (hinge(body).is_axis && can_push(body, state));
  }
  /// Lets a ball joint rest on a stop: it turns along it, or friction holds it.
  /// @param stop  index among its stops; -1: lets it leave
  void rest_on(int body, int stop, FrictionMemory& memory) {
    hinges_[body].rests_on = stop;
    memory.forget(body);
  }
  /// Whether a ball joint's stop would have to pull, by more than the
  /// uncertainty of its moment, after an evaluation.
  static bool pulls(int body, Hinges at) {
    return at.stop_moment(body) < -at.uncertain_moment();
  }

  /// Memory without any results.
  const FrictionMemory& beginning() const { return beginning_; }

  /// Resting and locked hinges are held, see Dynamics::set_mode(). The memory
  /// of the motion discards the hinge's earlier results.
  void set_mode(int body, HingeMode mode, FrictionMemory& memory);

  /// A ball joint about to stop: its dry friction keeps the direction in
  /// memory, independent of the state, so that it is smooth through the stop.
  /// Ends with set_mode().
  void slide_straight(int body, bool straight) {
    hinges_[body].straight = straight;
    hinges_[body].follows = false;
  }

  /// A ball joint that has just begun to slide straight: every evaluation
  /// solves for its direction, the direction of its acceleration, to
  /// HingeMemory::pace, because such a slow motion turns at once. Ends with
  /// slide_straight(). Such evaluations allocate.
  void follow_acceleration(int body) {
    hinges_[body].straight = hinges_[body].follows = true;
  }

  /// @param state  layout().size() numbers
  /// @param at     with forces and a prescribed carrier; receives the results
  const CoupledReport& evaluate(const double* state, FrictionMemory& memory,
                                Evaluation& at) const;

  /// Decides which of the resting hinges hold, which begin to slide in which
  /// direction, and which ball joints leave their stops. Then evaluates
  /// everything.
  /// @param due  a hinge is about to slide: half of the threshold beyond its
  ///   limit suffices for this hinge and for the hinges that slide with it
  const CoupledReport& resolve_rest(const double* state, FrictionMemory& memory,
                                    Evaluation& at, bool due = false);

  /// All hinges after the last evaluation.
  Hinges at(FrictionMemory& memory, Evaluation& evaluation) const {
    return {hinges_, memory, evaluation};
  }
  // After evaluate():
  /// tau of a resting hinge; NaN if one of its contacts has no value. Near 1
  /// the friction of the other hinges is solved to Hinges::refined_tolerance
  /// first.
  double utilisation(int body, Hinges at) const;
  /// Utilisation above which a resting hinge begins to slide: 1 plus
  /// CoupledOptions::slip_threshold, or plus the uncertainty of tau.
  double slip_limit(int body, Hinges at) const;
  /// Whether an implicit step of length `step` brings the ball joint of a
  /// sliding hinge to rest: the convex problem of the present contact
  /// (contact::MomentSet::prox()) with the effective inertia of the hinge.
  /// @param rate  relative angular velocity, link axes
  static bool stops_within(int body, const Eigen::Vector3d& rate, double step,
                           Hinges at);

 private:
  /// evaluate() in the present directions of sliding.
  const CoupledReport& find_friction(const double* state, Hinges& at) const;
  void solve(double tolerance, Hinges& at) const;
  void refine(Hinges& at) const;
  int worst_resting(bool due, Hinges& at) const;
  int worst_pulled(Hinges& at) const;
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
