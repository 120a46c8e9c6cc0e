#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "multibody/motion/equations.hpp"
#include "multibody/motion/impulse.hpp"
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
  /// Takes a hinge's relative velocity out of a state by an impulse in it; the
  /// other held hinges hold.
  void stop(int body, std::vector<double>& state);
  /// Takes those of several out by one impulse, and holds them from now on.
  void latch(double time, const std::vector<int>& bodies,
             std::vector<double>& state);
  /// Bodies that come to their stops go back from them, or rest there.
  void hit(double time, const std::vector<int>& bodies,
           std::vector<double>& state);
  /// The body rests on its stop now.
  void end_bounces(double time, int body);
  /// When that will be, else 0.
  double settle_time(int body) const { return settle_times_[body]; }
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
  const std::vector<HingeImpact>& impacts() const { return impacts_; }
  /// A start: nothing has changed so far.
  void forget() { all_.clear(); }

  /// As it was when a motion was saved.
  void restore(int body, double straight_from, double settle_time);

 private:
  bool is_on_stop(int body, const std::vector<double>& state) const {
    return coupled_.mode(body) == HingeMode::resting &&
           coupled_.can_push(body, state.data());
  }
  const HingeStop* stop_hit(int body, const std::vector<double>& state) const;
  /// A body that goes off from a stop.
  struct Bounce {
    const HingeStop* stop;
    double response = 0;  ///< of its rate to a unit impulse
    double rate = 0;      ///< >= 0, rad/s
    double pressed = 0;   ///< acceleration that brings it back, rad/s^2
  };
  void settle(double time, std::vector<Bounce>& bounces,
              std::vector<double>& state);
  std::vector<Impulse::Jump> jump(double time,
                                  const std::vector<Impulse::Target>& targets,
                                  bool ideal, std::vector<double>& state);
  void note_jumps(double time, const std::vector<Impulse::Target>& targets,
                  const std::vector<Impulse::Jump>& jumps, bool latches,
                  const std::vector<double>& before);

  Equations& equations_;
  MotionSample& view_;
  CoupledDynamics& coupled_;
  Impulse impulse_;
  double stop_speed_;
  int stall_changes_;
  double stall_span_;
  std::vector<double> straight_from_;
  std::vector<double> settle_times_;
  std::vector<HingeChange> all_;
  std::vector<HingeImpact> impacts_;
  /// Changes of a hinge between rest and slip, on its way to either too.
  struct Recent {
    double since = -std::numeric_limits<double>::infinity();
    int count = 0;
  };
  std::vector<Recent> recent_;
};

}  // namespace multibody
