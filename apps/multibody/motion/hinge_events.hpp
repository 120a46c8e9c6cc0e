#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "multibody/motion/crossings.hpp"
#include "multibody/motion/hinge_changes.hpp"

namespace multibody {

/// Events within a step: hinges that stop, slow down, turn or give way, and
/// bodies that reach or leave their stops.
class HingeEvents {
 public:
  /// Keeps references to all arguments.
  HingeEvents(Equations& equations, MotionSample& view, Stepper& stepper,
              const HingeChanges& hinges, const MotionOptions& options);

  /// The first events in the last step: all events at the same instant to the
  /// rounding of their times.
  std::vector<StepEvent> first();

 private:
  using Kind = StepEvent::Kind;
  /// Sliding in a known direction, until the velocity along it passes 0.
  bool slides_to_stop(int body) const;
  void sample();
  std::optional<double> slip_end(int body);
  std::optional<double> slowing(int body);
  std::optional<double> speeding(int body);
  std::optional<double> turning(int body);
  std::optional<double> rest_end(int body);
  double excess(int body);
  double pull(int body);
  std::optional<double> hit(int body);
  static std::optional<double> short_flight(const StepFunction& gap,
                                            double from);
  std::optional<double> reaches(int body, std::size_t stop);
  std::optional<double> comes_back(const StepFunction& gap,
                                   StepFunction::Values values, int body,
                                   int side);
  std::optional<double> settling(int body) const;
  bool stops_in_step(int body);
  /// Function of time for a value in view that passes 0.
  template <class Value>
  StepFunction function(Value value);

  MotionSample& view_;
  Equations& equations_;
  CoupledDynamics& coupled_;
  Stepper& stepper_;
  const HingeChanges& hinges_;
  bool fixed_steps_;
  // For each body, in the last step: direction for the end of sliding, and the
  // rate along it.
  struct Slip {
    Eigen::Vector3d direction;
    StepFunction::Values rates;
  };
  std::vector<Slip> slips_;
  /// For each body, from each of its stops.
  std::vector<std::vector<StepFunction::Values>> gaps_;
  std::vector<double> trial_;
};

}  // namespace multibody
