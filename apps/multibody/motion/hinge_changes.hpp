#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "multibody/motion/equations.hpp"
#include "multibody/motion/motion_sample.hpp"
#include "multibody/motion/motion_state.hpp"
#include "multibody/motion/stepper.hpp"

namespace multibody {

/// Rest and slip of the hinges as they change along the motion, and what the
/// changes do to a state.
class HingeChanges {
 public:
  /// Refers to both.
  HingeChanges(Equations& equations, MotionSample& view,
               const MotionOptions& options);

  /// Decides which hinges hold from this state on, see
  /// CoupledDynamics::resolve_rest(); not ok: undecided.
  CoupledReport resolve_rest(double time, const std::vector<double>& state,
                             bool due);
  /// It does so now.
  void change(double time, int body, HingeMode mode);
  /// Takes a hinge's relative velocity out of a state by an impulse in it.
  void stop(int body, std::vector<double>& state);
  /// A ball joint slides straight on as it does in view, or no longer does.
  void slide_straight(int body, bool straight);
  /// Why the motion stops if the hinge changes so often that time does not get
  /// on.
  std::optional<std::string> stalls(double time, int body);

  /// Speed below which sliding ball joints slide straight on, rad/s.
  double stop_speed() const { return stop_speed_; }
  /// Speed at which a ball joint began to do so.
  double straight_from(int body) const { return straight_from_[body]; }
  const std::vector<HingeChange>& all() const { return all_; }
  /// A start: nothing has changed so far.
  void forget() { all_.clear(); }

  /// As it was when a motion was saved.
  void restore(int body, double straight_from);

 private:
  Equations& equations_;
  MotionSample& view_;
  CoupledDynamics& coupled_;
  Dynamics impulse_;
  double stop_speed_;
  int stall_changes_;
  double stall_span_;
  std::vector<double> straight_from_;
  std::vector<HingeChange> all_;
  /// Changes of a hinge between rest and slip, on its way to either too.
  struct Recent {
    double since = -std::numeric_limits<double>::infinity();
    int count = 0;
  };
  std::vector<Recent> recent_;
};

}  // namespace multibody
