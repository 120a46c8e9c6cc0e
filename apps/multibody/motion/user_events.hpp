#pragma once

#include <optional>
#include <vector>

#include "multibody/motion/crossings.hpp"
#include "multibody/motion/motion_state.hpp"
#include "multibody/motion/stepper.hpp"

namespace multibody {

/// Events of the application: their functions along the steps.
class UserEvents {
 public:
  /// Keeps a reference to the view.
  explicit UserEvents(MotionSample& view) : view_(view) {}

  /// Adds an event, effective from the state in view on.
  /// @return its index
  int add(MotionEvent event);
  /// Restarts all events from the state in view.
  void restart();

  /// Evaluates the functions in the last step.
  void sample(Stepper& stepper);
  /// First crossing in that step; call after sample().
  std::optional<StepEvent> first(Stepper& stepper);

  /// Call if no event occurred up to the end of that step, or to the state in
  /// view.
  void go_on();
  void go_on_from_view();
  /// Call after this event has occurred, in view.
  void report(const StepEvent& event);
  /// Event whose function jumped over 0, to the state in view, when a hinge
  /// changed.
  std::optional<int> jumped();

 private:
  struct Watched {
    MotionEvent event;
    double before;  ///< its value before the step
    bool needs_forces = false;
    /// Values in the last step; full: all of them, not just the end and middle.
    StepFunction::Values values{};
    bool full = true;
    std::optional<StepFunction::Crossed> crossed{};
  };
  static void note(Watched& watched, double value);
  std::optional<StepFunction::Crossed> first_rise(const Watched& watched,
                                                  Stepper& stepper);

  MotionSample& view_;
  std::vector<Watched> all_;
};

}  // namespace multibody
