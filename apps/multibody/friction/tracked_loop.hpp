#pragma once

#include <Eigen/Core>
#include <vector>

#include "multibody/friction/coupled_report.hpp"
#include "multibody/friction/friction_tracker.hpp"

namespace multibody {

class Hinges;

/// Brings friction moments and reactions into agreement with an evaluation or
/// two of every contact, by the joints tracked from one instant to the next:
/// as long as they can be trusted, and where it is likely to work.
class TrackedLoop {
 public:
  TrackedLoop(const std::vector<HingeFriction>& friction,
              const CoupledOptions& options)
      : tracker_(friction), tolerance_(options.tolerance) {}

  /// After Hinges::set_state(): where the state goes on in the direction of
  /// its last move, moments do too.
  void extrapolate(Hinges& hinges);
  /// After Hinges::start().
  /// @return false: others have to find the moments
  bool converge(Hinges& hinges);
  /// After others have found them: from the last solutions of the hinges'
  /// solvers, where tracking is likely to work the next time.
  void start(const Hinges& hinges);
  /// Call after a hinge changed its mode; discards the tracked state.
  void stop(int body);
  /// Forgets the path of the motion, which no longer tells where it goes.
  void forget_path();
  /// Moments of hinges were changed by others.
  void forget_applied() { applied_known_ = false; }

  /// Largest (leverage |M_t|/|R|)^2 of the hinges, infinity if it is not
  /// known.
  double largest_leverage() const;
  /// Ratio of the changes of M_t(R) to those of M_t, as a rule.
  void learn_contraction(double contraction);

 private:
  bool track(Hinges& hinges);
  bool track_joints(Hinges& hinges);
  double relax(Hinges& hinges, double enough);
  void learn_step(CoupledReport& report, double residual);
  void keep();
  void take_applied_moments(Hinges& hinges);

  FrictionTracker tracker_;
  double tolerance_;
  // State of the last evaluation tracked, its move from the one before, that of
  // the present one from it; how many have been kept since the path began.
  Eigen::VectorXd path_end_, path_, step_;
  double path_square_ = 0, step_square_ = 0;  // squared lengths
  int kept_ = 0;
  // Whether the tracker's applied moments are those of the hinges; as track()
  // left them the largest, squared, and the largest of the leverages.
  bool applied_known_ = false;
  double largest_applied_ = 0;
  double largest_leverage_ = 0;
  double last_residual_ = 0;  // before the last step of relax(); 0: none yet
  double usual_contraction_ = 1;
  bool is_weak_ = false;  // the present contraction is weak
  int pause_ = 0;         // evaluations until tracking is tried again
  int last_pause_ = 0;
};

}  // namespace multibody
