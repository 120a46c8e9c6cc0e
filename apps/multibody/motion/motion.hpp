// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "multibody/motion/motion_options.hpp"
#include "multibody/motion/motion_sample.hpp"
#include "multibody/motion/motion_state.hpp"
#include "multibody/system/system.hpp"

namespace multibody {

/// Reason for the return of advance_to().
enum class Stop {
  time,    ///< requested time reached
  event,   ///< an application's event
  failed,  ///< see Motion::failure()
  halted,  ///< at the end of a step, by halt_when()
};

class Equations;
class HingeChanges;
class ForceKinks;
class HingeEvents;
class StepPath;
class Stepper;
class UserEvents;

/// Changes at one instant.
struct MotionChange {
  std::vector<int> unlocked{};  ///< bodies
  std::vector<int> released{};
  std::vector<int> latched{};
  /// New forces; if not set the forces do not change.
  std::optional<std::shared_ptr<const ForceModel>> forces{};
};

/// The motion of a carrier with bodies through time.
///
/// All vectors are in body axes (system/system.hpp) or inertial axes. Rest and
/// slip of the hinges are determined along the motion: a resting hinge has a
/// relative velocity of exactly 0 and a bit-identical position.
///
/// Accuracy (libcontact/docs/reference/accuracy.md, multibody/motion_test.cpp):
/// stops, onsets of sliding and energies agree with closed forms to 1e-9 or the
/// chosen tolerance.
class Motion {
 public:
  /// @param friction  one for each body, or empty
  /// @param forces    may be null
  /// @throws contact::Error for friction that does not suit the hinge and a
  ///         start that does not suit the system
  Motion(const System& system, std::vector<HingeFriction> friction,
         std::shared_ptr<const ForceModel> forces, const MotionStart& start,
         const MotionOptions& options = {});
  ~Motion();
  Motion(Motion&&) noexcept;
  Motion& operator=(Motion&&) noexcept;

  double time() const { return now_; }
  /// Advances to `time`, or to the first event or failure before it. Each event
  /// stops the motion once at each crossing. The later motion is bit-identical,
  /// independent of stops and queries.
  /// @param time  >= time()
  Stop advance_to(double time);
  /// Index of the event that stopped advance_to().
  int event() const { return event_; }
  /// Set if advance_to(), or another change of the motion, failed.
  /// Motion::restore() resets it.
  const std::optional<MotionFailure>& failure() const { return failure_; }

  /// At time().
  const MotionSample& sample() const;

  /// Changes at time(). A released body has no hinge; a latched hinge is held.
  /// An impulse that conserves momentum, one for all hinges latched at once,
  /// removes its relative velocity; resting hinges are ideal in that instant.
  /// unlock() opens latches too.
  void release(int body) { change({.unlocked = {}, .released = {body}}); }
  void latch(int body) {
    change({.unlocked = {}, .released = {}, .latched = {body}});
  }
  void unlock(int body) { change({.unlocked = {body}}); }
  void set_forces(std::shared_ptr<const ForceModel> forces) {
    change({.forces = std::move(forces)});
  }
  /// Applies all changes, then decides once which hinges hold.
  void change(const MotionChange& what);

  /// Adds an event; its index.
  int add_event(MotionEvent event);

  /// Calls `look` with the motion at the end of every step, and just before and
  /// after jumps of forces and changes of hinges; not where advance_to() stops.
  void watch_steps(std::function<void(const MotionSample&)> look) {
    step_watch_ = std::move(look);
  }

  /// Calls `halt` before every step; true: advance_to() returns, and may be
  /// called again.
  void halt_when(std::function<bool()> halt) { halt_ = std::move(halt); }

  /// Start of the step that contains sample() or ends at it.
  double step_begin() const;
  /// Length of the last step, s.
  double last_step() const;
  /// The body (as in motions()) with the largest error of its motion or hinge
  /// in the last step relative to the tolerances, which limits the step. -1:
  /// the work of the forces, or unknown, as with rk4.
  int held_by() const;
  /// Calls `look` with the motion at a time between step_begin() and the time
  /// of sample(), by dense output. Also from within watch_steps().
  void look_back(double time,
                 const std::function<void(const MotionSample&)>& look) const;

  /// The carrier (0) or a body (1 +) at such a time: for many queries of few
  /// bodies.
  BodyMotion place_back(int body, double time) const;

  /// Changes between rest, slip, locked and released so far, in order.
  const std::vector<HingeChange>& changes() const;
  /// Impacts on stops and by latches so far, in order.
  const std::vector<HingeImpact>& impacts() const;

  /// Restarts the steps: this motion and a motion that restores the state
  /// continue bit-identically.
  MotionState save();
  /// @throws contact::Error, without a change, if no motion of this system and
  ///   friction has such a state
  void restore(const MotionState& state);

  MotionCounts counts() const;

 private:
  bool step();
  bool pass_break();
  void keep_on_cones();
  void show_step(double time);
  bool redo_step_to(double time);
  bool end_at_kink();
  bool keep_directions();
  std::vector<StepEvent> find_events();
  bool handle(const std::vector<StepEvent>& found);
  bool pass_event(const StepEvent& event, std::vector<double>& state);
  std::vector<double> let_go(int body, const std::vector<double>& from);
  void go_to(double time);
  void restart(std::vector<double> state);
  bool resume(std::vector<double> state, bool due = false);
  void set_failure(const CoupledReport& report, double time);

  // These members refer to each other and must not move.
  std::unique_ptr<Equations> equations_;
  std::unique_ptr<MotionSample> view_;
  std::unique_ptr<Stepper> stepper_;
  std::unique_ptr<StepPath> path_;
  std::unique_ptr<ForceKinks> kinks_;
  std::unique_ptr<HingeEvents> hinge_events_;
  std::unique_ptr<UserEvents> user_events_;
  std::unique_ptr<HingeChanges> hinges_;

  MotionOptions options_;
  std::function<void(const MotionSample&)> step_watch_;
  std::function<bool()> halt_;
  std::optional<MotionFailure> failure_;
  std::vector<StepEvent> pending_;  ///< at one instant
  double now_;
  int event_ = -1;
  int changes_here_ = 0;  ///< at one and the same time
  double changes_time_ = 0;
  long steps_ = 0;
};

}  // namespace multibody
