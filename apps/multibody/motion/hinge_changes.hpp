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

/// Changes between rest and slip of the hinges along the motion, and their
/// effect on a state.
class HingeChanges {
 public:
  /// Keeps references to both arguments.
  HingeChanges(Equations& equations, MotionSample& view,
               const MotionOptions& options);

  /// Decides which hinges hold in this state, see
  /// CoupledDynamics::resolve_rest(); not ok: undecided.
  CoupledReport resolve_rest(double time, const std::vector<double>& state,
                             bool due);
  /// Changes the mode of a hinge now.
  void change(double time, int body, HingeMode mode);
  /// Removes a hinge's relative velocity from a state by an impulse in the
  /// hinge; the other held hinges hold.
  void stop(int body, std::vector<double>& state);
  /// Removes the velocities of several hinges by one impulse, and holds these
  /// hinges.
  void latch(double time, const std::vector<int>& bodies,
             std::vector<double>& state);
  /// Lets bodies that reach their stops rebound or rest there. A slow ball
  /// joint with dry friction rests on both.
  void hit(double time, const std::vector<int>& bodies,
           std::vector<double>& state);
  /// Puts the body to rest on its stop.
  void end_bounces(double time, int body);
  /// Lets a ball joint leave its stop.
  void leave_stop(double time, int body);
  /// Whether ball joints turn along their stops.
  bool any_on_cones() const;
  /// Removes what a step has added to their angles and rates.
  void put_on_cones(std::vector<double>& state) const;
  /// Time at which its bounces end and it rests on its stop, else 0.
  double settle_time(int body) const { return settle_times_[body]; }
  /// Lets a ball joint slide straight in its direction in view, or ends this.
  void slide_straight(int body, bool straight);
  /// Reason for a failure if the hinge changes so often that time does not
  /// advance.
  std::optional<std::string> stalls(double time, int body);

  /// Speed below which sliding ball joints slide straight, rad/s.
  double stop_speed() const { return stop_speed_; }
  /// Speed at which a ball joint began to slide straight.
  double straight_from(int body) const { return straight_from_[body]; }
  const std::vector<HingeChange>& all() const { return all_; }
  const std::vector<HingeImpact>& impacts() const { return impacts_; }
  /// Forgets the changes so far, at a start.
  void forget() { all_.clear(); }

  /// Restores a saved motion.
  void restore(int body, double straight_from, double settle_time);

 private:
  bool is_on_stop(int body, const std::vector<double>& state) const;
  const HingeStop* stop_hit(int body, const std::vector<double>& state) const;
  Impulse::Target rebound(const HingeStop& stop, std::vector<double>& state);
  void rest_on(const HingeStop& stop);
  void fly_from(const HingeStop& stop);
  void hold_slow(double time, int body, std::vector<double>& state);
  /// A body that leaves a stop.
  struct Bounce {
    const HingeStop* stop;
    std::optional<Eigen::Vector3d> along = {};  ///< as Impulse::Target::along
    double response = 0;                        ///< rate per unit impulse
    double rate = 0;                            ///< >= 0, rad/s
    double pressed = 0;  ///< acceleration that brings it back, rad/s^2
  };
  void settle(double time, std::vector<Bounce>& bounces,
              std::vector<double>& state);
  std::vector<Bounce> at_stops(const std::vector<double>& state) const;
  void add_driven_off(double time, const std::vector<Bounce>& rested,
                      const std::vector<double>& state,
                      std::vector<Bounce>& to);
  std::vector<Impulse::Target> with_stops(
      double time, const std::vector<Impulse::Target>& targets,
      const std::vector<double>& state);
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
  /// Changes of a hinge between rest and slip, including transitions.
  struct Recent {
    double since = -std::numeric_limits<double>::infinity();
    int count = 0;
  };
  std::vector<Recent> recent_;
};

}  // namespace multibody
