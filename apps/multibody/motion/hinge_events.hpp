#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "multibody/motion/crossings.hpp"
#include "multibody/motion/hinge_changes.hpp"

namespace multibody {

/// Events within a step: hinges that stop, slow down, turn or give way, and
/// bodies that come to their stops.
class HingeEvents {
 public:
  /// Refers to all of them.
  HingeEvents(Equations& equations, MotionSample& view, Stepper& stepper,
              const HingeChanges& hinges, const MotionOptions& options);

  /// The first of them in the last step, and those at the same instant: as
  /// near as the rounding of their times cannot tell apart.
  std::vector<StepEvent> first();

 private:
  using Kind = StepEvent::Kind;
  /// Slides in a known direction, to where that velocity passes 0.
  bool slides_to_stop(int body) const;
  void sample();
  std::optional<double> slip_end(int body);
  std::optional<double> slowing(int body);
  std::optional<double> speeding(int body);
  std::optional<double> turning(int body);
  std::optional<double> rest_end(int body);
  double excess(int body);
  std::optional<double> hit(int body);
  static std::optional<double> short_flight(const StepFunction& gap,
                                            double from);
  std::optional<double> comes_back(const StepFunction& gap,
                                   StepFunction::Values values, int body,
                                   int side);
  std::optional<double> settling(int body) const;
  bool stops_in_step(int body);
  /// Function of a value in view that passes 0.
  template <class Value>
  StepFunction function(Value value);

  MotionSample& view_;
  Equations& equations_;
  CoupledDynamics& coupled_;
  Stepper& stepper_;
  const HingeChanges& hinges_;
  bool fixed_steps_;
  // For each body, in the last step: direction in which the end of sliding is
  // looked for, and the rate along it.
  struct Slip {
    Eigen::Vector3d direction;
    StepFunction::Values rates;
  };
  std::vector<Slip> slips_;
  std::vector<StepFunction::Values> angles_;  ///< where there are stops
  std::vector<double> trial_;
};

}  // namespace multibody
