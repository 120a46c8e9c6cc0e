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

/// Why advance_to() came back.
enum class Stop {
  time,    ///< the time asked for
  event,   ///< an application's event
  failed,  ///< Motion::failure() says why
  halted,  ///< at the end of a step, as halt_when() wanted
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
  /// New forces; the old ones stay if it is not set.
  std::optional<std::shared_ptr<const ForceModel>> forces{};
};

/// A carrier with bodies moving through time.
///
/// All vectors come and go in body axes (system/system.hpp) or inertial axes.
/// The hinges' rest and slip are found on the way: a resting hinge has relative
/// velocity exactly 0 and stays where it is to the last bit.
///
/// Accuracy (libcontact/docs/reference/accuracy.md, multibody/motion_test.cpp):
/// stops, onsets of sliding and energies meet closed forms to 1e-9 or the
/// chosen tolerance.
class Motion {
 public:
  /// @param friction  one for each body, or none at all
  /// @param forces    may be null
  /// @throws contact::Error for friction that does not fit the hinge and a
  ///         start that does not fit the system
  Motion(const System& system, std::vector<HingeFriction> friction,
         std::shared_ptr<const ForceModel> forces, const MotionStart& start,
         const MotionOptions& options = {});
  ~Motion();
  Motion(Motion&&) noexcept;
  Motion& operator=(Motion&&) noexcept;

  double time() const { return now_; }
  /// Moves on to `time`, or to the first event or failure before it. Each
  /// event stops once at each crossing.
  /// Where it stops, and what is asked of it there, changes nothing of what
  /// follows, to the last bit.
  /// @param time  >= time()
  Stop advance_to(double time);
  /// Index of the event that stopped advance_to().
  int event() const { return event_; }
  /// Set if advance_to(), or anything else that changes the motion, failed.
  /// Motion::restore() brings it back.
  const std::optional<MotionFailure>& failure() const { return failure_; }

  /// At time().
  const MotionSample& sample() const;

  /// From now on, at time(). A released body is a body of its own; a
  /// latched one is held from now on. Its relative velocity is taken out by an
  /// impulse that keeps the momentum, one for all that are latched at once;
  /// hinges that rest are ideal in that instant. To unlock opens latches too.
  void release(int body) { change({.unlocked = {}, .released = {body}}); }
  void latch(int body) {
    change({.unlocked = {}, .released = {}, .latched = {body}});
  }
  void unlock(int body) { change({.unlocked = {body}}); }
  void set_forces(std::shared_ptr<const ForceModel> forces) {
    change({.forces = std::move(forces)});
  }
  /// Makes the changes, then decides once which hinges hold.
  void change(const MotionChange& what);

  /// Adds an event; its index.
  int add_event(MotionEvent event);

  /// Calls `look` with the motion at the end of every step that it goes on
  /// from, where forces jump or hinges change just before and after; not where
  /// advance_to() stops.
  void watch_steps(std::function<void(const MotionSample&)> look) {
    step_watch_ = std::move(look);
  }

  /// Asks `halt` before every step; true: advance_to() comes back. It may be
  /// called again.
  void halt_when(std::function<bool()> halt) { halt_ = std::move(halt); }

  /// Beginning of the step that contains sample() or ends at it.
  double step_begin() const;
  /// Length of the last step, s.
  double last_step() const;
  /// The body (as in motions()) whose motion, or whose hinge's, had the largest
  /// error in the last step against the tolerances: what keeps steps short. -1:
  /// the work of the forces, or not known, as with rk4.
  int held_by() const;
  /// Calls `look` with the motion at a time from step_begin() to that of
  /// sample(), by dense output. Also from within watch_steps().
  void look_back(double time,
                 const std::function<void(const MotionSample&)>& look) const;

  /// The carrier (0) or a body (1 +) at such a time: for many looks at few
  /// bodies.
  BodyMotion place_back(int body, double time) const;

  /// Sticking, sliding, locking and releasing so far, in order.
  const std::vector<HingeChange>& changes() const;
  /// Impacts on stops and by latches so far, in order.
  const std::vector<HingeImpact>& impacts() const;

  /// Begins the steps anew: from now on this motion goes on as one that
  /// restores the state does, to the last bit.
  MotionState save();
  /// @throws contact::Error, having changed nothing, if no motion of this
  ///   system and friction has such a state
  void restore(const MotionState& state);

  MotionCounts counts() const;

 private:
  bool step();
  bool pass_break();
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

  // These refer to each other, and must not move.
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
