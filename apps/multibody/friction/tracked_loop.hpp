#pragma once

#include <Eigen/Core>
#include <vector>

#include "multibody/friction/coupled_report.hpp"
#include "multibody/friction/friction_tracker.hpp"

namespace multibody {

class Hinges;

/// Iterates friction moments and reactions to agreement with one or two
/// evaluations of every contact, by joints tracked from one instant to the
/// next, as long as the tracking is trusted and likely to succeed.
class TrackedLoop {
 public:
  TrackedLoop(const std::vector<HingeFriction>& friction,
              const CoupledOptions& options)
      : tracker_(friction), tolerance_(options.tolerance) {}

  /// Call after Hinges::set_state(). If the state continues in the direction of
  /// its last move, moments are extrapolated.
  void extrapolate(Hinges& hinges);
  /// Call after Hinges::start().
  /// @return false: other methods must find the moments
  bool converge(Hinges& hinges);
  /// Call after other methods have found the moments: starts from the last
  /// solutions of the hinges' solvers, if tracking is likely to succeed next
  /// time.
  void start(const Hinges& hinges);
  /// Call after a hinge changed its mode; discards the tracked state.
  void stop(int body);
  /// Discards the path of the motion, which no longer predicts the next state.
  void forget_path();
  /// Call after other code changed moments of hinges.
  void forget_applied() { applied_known_ = false; }

  /// Largest (leverage |M_t|/|R|)^2 of the hinges, infinity if unknown.
  double largest_leverage() const;
  /// Records a ratio of the changes of M_t(R) to the changes of M_t.
  void learn_contraction(double contraction);

 private:
  bool track(Hinges& hinges);
  bool track_joints(Hinges& hinges);
  bool restart(Hinges& hinges);
  double relax(Hinges& hinges, double enough);
  void learn_step(CoupledReport& report, double residual);
  void keep();
  void take_applied_moments(Hinges& hinges);

  FrictionTracker tracker_;
  double tolerance_;
  // State of the last tracked evaluation, its move from the previous one, the
  // move of the present one from it; number of states since the path began.
  Eigen::VectorXd path_end_, path_, step_;
  double path_square_ = 0, step_square_ = 0;  // squared lengths
  int kept_ = 0;
  // Whether the tracker's applied moments equal the hinges' moments; the
  // largest moment, squared, and the largest leverage after track().
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
