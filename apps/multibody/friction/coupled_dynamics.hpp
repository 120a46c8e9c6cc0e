#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "multibody/dynamics/dynamics.hpp"
#include "multibody/friction/hinge_friction.hpp"

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
  /// By which bodies are resolved and joints are tracked: a supported one.
  contact::InstructionSet instruction_set = contact::best_instruction_set();
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
  /// Of each body, link axes, N m; 0 where no friction is looked for.
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
  int body = -1;  ///< where it failed, -1: nowhere in particular
  /// no_contact: which joint of that body's hinge, and the force on it, N.
  int joint = -1;
  double force = 0;
};

/// What rounding makes of reactions that cancel: an upper estimate.
struct CoupledRounding {
  double force;   ///< N
  double moment;  ///< N m
};

/// A step of the outer loop.
struct OuterStep {
  int iteration;
  double residual;
};

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
  CoupledDynamics(const System& system, std::vector<HingeFriction> friction,
                  const CoupledOptions& options = {});
  ~CoupledDynamics();
  CoupledDynamics(CoupledDynamics&&) noexcept;
  CoupledDynamics& operator=(CoupledDynamics&&) noexcept;

  int size() const;
  const Dynamics& dynamics() const;
  const StateLayout& layout() const;
  HingeMode mode(int body) const;
  /// Resting and locked hinges are held, see Dynamics::set_mode().
  void set_mode(int body, HingeMode mode);
  /// Whether the hinge has friction that can hold it at rest.
  bool can_rest(int body) const;
  bool has_friction(int body) const;

  /// Direction of sliding where the state's relative velocity is exactly 0,
  /// and on an axis always: its z is the sign. Unit vector, link axes.
  void set_direction(int body, const Eigen::Vector3d& direction);
  const Eigen::Vector3d& direction(int body) const;

  /// A ball joint about to stop: its dry friction keeps its direction(),
  /// whatever the state says, so that it is smooth through the stop. Ends
  /// with set_mode().
  void slide_straight(int body, bool straight);
  bool slides_straight(int body) const;

  /// A ball joint that has just begun to slide straight: its direction() is
  /// found anew in every evaluation, as that in which the joint accelerates.
  /// So slow a motion turns there at once. Ends with slide_straight(). Such
  /// evaluations allocate.
  /// @param pace  size of the accelerations by which its direction is judged,
  ///   rad/s^2; as resolve_rest() has found it if left out
  void follow_acceleration(int body);
  void follow_acceleration(int body, double pace);
  bool follows_acceleration(int body) const;
  double pace(int body) const;

  /// The carrier's accelerations are given, or (nullopt) result.
  void prescribe_carrier(
      const std::optional<CarrierAcceleration<double>>& carrier);

  /// State and forces have to stay where they are until the next evaluation:
  /// what is asked for after this one may look at them.
  /// @param state    layout().size() numbers
  /// @param forces  its friction moments are replaced by those found
  const CoupledReport& evaluate(const double* state,
                                ActiveForces<double>& forces);
  const CoupledReport& report() const;
  /// Records the steps of the next evaluations; null: no longer.
  void set_trace(std::vector<OuterStep>* trace);

  /// After evaluate().
  const Eigen::Vector3d& friction_moment(int body) const;
  /// Where the next evaluation starts from.
  void set_friction_moment(int body, const Eigen::Vector3d& moment);
  const Reaction<double>& reaction(int body) const;
  /// tau of a resting hinge; NaN where a contact of it has no value.
  double utilisation(int body);
  /// Utilisation above which a resting hinge begins to slide.
  double slip_limit(int body) const;
  std::span<const contact::JointSolution> joints(int body) const;
  /// A joint of a hinge with friction.
  const contact::JointContact& contact(int body, int joint) const;

  /// What the search of the last evaluation found; empty if there was none.
  std::span<const CoupledSolution> solutions() const;

  /// Decides which of the hinges that are resting hold, and which begin to
  /// slide and where to; `forced` (-1: none) slides if it is half of the
  /// threshold beyond what it can hold. Then all is evaluated.
  const CoupledReport& resolve_rest(const double* state,
                                    ActiveForces<double>& forces,
                                    int forced = -1);

  /// Of the last evaluation. Reactions below it are taken for 0 where rest is
  /// decided.
  CoupledRounding rounding() const;

  /// After evaluate(): whether an implicit step of length `step` brings the
  /// ball joint of a sliding hinge to rest: the convex problem of the contact
  /// as it is (contact::MomentSet::prox()) with the inertia that the hinge
  /// feels.
  /// @param rate  relative angular velocity, link axes
  bool stops_within(int body, const Eigen::Vector3d& rate, double step);

  /// kappa_i = |dM_i/dR_i||dR_i/dM_i| of a sliding hinge, after evaluate().
  double kappa(int body);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace multibody
