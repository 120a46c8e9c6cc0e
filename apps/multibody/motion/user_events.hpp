#pragma once

#include <optional>
#include <vector>

#include "multibody/motion/crossings.hpp"
#include "multibody/motion/motion_state.hpp"
#include "multibody/motion/stepper.hpp"

namespace multibody {

/// The application's events: their functions along the steps.
class UserEvents {
 public:
  /// Refers to the view.
  explicit UserEvents(MotionSample& view) : view_(view) {}

  /// From the state in view on.
  /// @return its index
  int add(MotionEvent event);
  /// All begin anew from the state in view.
  void restart();

  /// Looks at the last step.
  void sample(Stepper& stepper);
  /// After sample(): the first crossing in that step.
  std::optional<StepEvent> first(Stepper& stepper);

  /// Nothing happened up to the end of that step, or to the state in view.
  void go_on();
  void go_on_from_view();
  /// This event has happened, in view.
  void report(const StepEvent& event);
  /// An event whose function jumped over 0, to the state in view, when a hinge
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
