#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "multibody/friction/coupled_dynamics.hpp"
#include "multibody/motion/motion.hpp"
#include "multibody/motion/stepper.hpp"

namespace multibody {

/// The parts of Motion: motion_rates.cpp has the right-hand side and what is
/// seen of a state, motion_modes.cpp stops and changes of hinges,
/// motion_events.cpp finds them, with motion_crossings.cpp for what crosses 0
/// within a step, motion.cpp is the way through time.
///
/// Numbers of a state: those of StateLayout; for each body the work that
/// friction took; the work of the force model; for each body the integral of
/// what a held hinge transmits, in units of its first value. The last are
/// there for the error control alone: while hinges rest nothing else in the
/// state tells it how fast the forces change that may end the rest.
class MotionImpl {
 public:
  MotionImpl(const System& system, std::vector<HingeFriction> friction,
             std::shared_ptr<const ForceModel> forces, const MotionStart& start,
             const MotionOptions& options);

  // motion.cpp
  Stop advance_to(double time, bool look);
  void go_to(double time);
  void restart(std::vector<double> state);
  void look_back(double time,
                 const std::function<void(const MotionSample&)>& look);
  int held_by() const;
  MotionState state_of(double time, std::span<const double> numbers) const;
  MotionState step_state() const;
  MotionState save();
  void restore(const MotionState& state);

  // motion_rates.cpp
  bool rates(double time, const double* state, double* to);
  /// Makes a state the one that sample() shows.
  void look_at(double time, std::span<const double> state);
  /// Its accelerations and reactions, once.
  bool work_out();
  HingeSample hinge(int body);
  EnergyBook energy() const;
  Eigen::Vector3d acceleration(int place);
  Eigen::Vector3d angular_acceleration(int place);

  // motion_modes.cpp
  void change_mode(int body, HingeMode mode);
  void release(int body);
  void lock(int body);
  void unlock(int body);
  /// Takes a hinge's relative velocity out of a state.
  void stop_hinge(int body, std::vector<double>& state);
  /// Which hinges hold from here on; false if that cannot be said.
  bool resolve_rest(const std::vector<double>& state, int forced);

  // motion_events.cpp
  struct Watch {
    enum class Kind {
      /// Sliding about a known direction passes 0.
      slip_ends,
      /// A ball joint is about to stop: from here on it slides straight on.
      slows_down,
      /// It does not stop after all.
      speeds_up,
      /// It turns against itself within a step.
      slip_turns,
      rest_ends,
      user
    } kind;
    int index;
  };
  struct Found {
    double time;
    Watch watch;
    bool rises = false;  ///< user: which way
  };
  double value(const Watch& watch);
  /// The first crossing of the last step.
  std::optional<Found> find_event();
  bool stops_in_step(int body);
  std::optional<double> crossing(const Watch& watch);
  double value_at(const Watch& watch, double time);
  std::optional<double> rest_end(const Watch& watch, double end);
  std::pair<double, double> peak_between(const Watch& watch, double low,
                                         double low_value, double high,
                                         double high_value);
  double locate(const Watch& watch, double low, double low_value, double high,
                double high_value);
  bool handle(const Found& found);
  bool stalls(int body);

  // motion_crossings.cpp
  /// Values at points of the last step, those of the beginning first.
  struct StepSamples {
    static constexpr int last = 6;
    using Values = std::array<double, last + 1>;
    std::vector<Values> user;  ///< of each event
    std::vector<char> full;    ///< all of them, not just the end and middle
    std::vector<Values> slip;  ///< of each body: rate along its direction
  };
  struct Crossed {
    double time;
    bool rises;
  };
  bool slides_to_stop(int body) const {
    return coupled.mode(body) == HingeMode::sliding &&
           coupled.hinge(body).can_rest &&
           (is_axis(body) || coupled.hinge(body).straight);
  }
  double sample_time(int k) const;
  void sample_step();
  std::optional<Crossed> first_crossing(const Watch& watch,
                                        StepSamples::Values values,
                                        double before,
                                        MotionEvent::Crossing way);
  std::optional<Crossed> user_crossing(int event);
  std::optional<double> slip_end(int body);
  void note_user_value(int event, double value);
  void note_user_values();
  std::optional<int> user_jump();

  int size() const { return system.size(); }
  bool is_axis(int body) const {
    return system.links()[body].kind == HingeKind::axis;
  }
  int dissipated_at(int body) const { return coupled.layout().size() + body; }
  int work_at() const { return dissipated_at(size()); }
  int held_at(int body) const { return work_at() + 1 + body; }
  int number_count() const { return held_at(size()); }
  double held_rate(int body) const;
  void set_held_units();
  Eigen::Vector3d relative_acceleration(int body) const {
    const Vec3<double> a = coupled.dynamics().relative_acceleration(body);
    return {a.x, a.y, a.z};
  }
  Eigen::Vector3d rate_of(int body, const double* state) const;
  /// For when the body is released.
  void keep_hinge_angle(int body, double angle) {
    motions[1 + body].hinge_angle = rate_motions_[1 + body].hinge_angle = angle;
  }
  void set_failure(const CoupledReport& report, double time);

  System system;
  MotionOptions options;
  double stop_speed;
  std::shared_ptr<const ForceModel> forces;
  CoupledDynamics coupled;
  Dynamics impulse;
  std::vector<JointMode> joint_modes;
  std::unique_ptr<Stepper> stepper;
  std::vector<MotionEvent> events;
  std::vector<double> user_values;
  std::function<void(const MotionSample&)> step_watch;
  std::function<bool()> halt;
  /// Size of the value of an event at 0 whose sign is known, whatever rounding
  /// says: of one that has been reported, or is about to be.
  static constexpr double just_crossed = std::numeric_limits<double>::min();
  /// Of each event: its function has asked for forces.
  std::vector<char> needs_forces;
  std::vector<std::optional<Crossed>> crossings;  ///< in the last step
  StepSamples samples;
  /// Speed at which a ball joint began to slide straight on.
  std::vector<double> straight_from;
  /// In which sliding is looked at for its end, in the last step.
  std::vector<Eigen::Vector3d> slip_directions;
  std::vector<HingeChange> changes;
  std::optional<MotionFailure> failure;
  std::optional<Found> pending;
  CoupledReport failed_report;
  double failed_time = 0;
  double now = 0;
  /// Of the forces, after the step under way.
  double next_break = std::numeric_limits<double>::infinity();
  int event = -1;
  int changes_here = 0;  ///< at one and the same time
  double changes_time = 0;
  MotionCounts counts;

  // What sample() shows.
  MotionSample sample;
  double view_time = 0;
  std::vector<double> view_state, view_rates;
  std::vector<BodyMotion> motions;
  bool worked_out = false;
  bool worked_well = false;

 private:
  std::vector<double> start_state(const MotionStart& start);
  bool pass_break();
  void show_step(double time);
  bool step();
  bool redo_step_to(double time);
  bool keep_directions();

  std::vector<BodyForce> body_forces_;
  std::vector<BodyMotion> rate_motions_;
  ActiveForces<double> forces_;
  std::vector<double> trial_;
  /// Changes of a hinge between rest and slip, on its way to either too.
  struct Recent {
    double since = -std::numeric_limits<double>::infinity();
    int count = 0;
  };
  std::vector<Recent> recent_;
  bool forces_asked_ = false;
  struct Unit {
    double force = 1;
    double moment = 1;
  };
  std::vector<Unit> held_units_;
};

}  // namespace multibody
