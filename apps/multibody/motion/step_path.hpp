#pragma once

#include <vector>

#include "multibody/motion/equations.hpp"
#include "multibody/motion/stepper.hpp"

namespace multibody {

/// Places of single bodies within the last step, for those who ask for many:
/// its dense output as polynomials, made once a step when it is asked for.
class StepPath {
 public:
  /// Refers to both.
  StepPath(const Equations& equations, Stepper& stepper)
      : equations_(equations), stepper_(stepper) {}

  /// The carrier (0) or a body (1 +) at a time of the step, as dense output has
  /// it to rounding; a released body without its hinge angle.
  BodyMotion place(int body, double time);

 private:
  void fit();
  const double* numbers(int first, int count, double time);

  const Equations& equations_;
  Stepper& stepper_;
  long serial_ = 0;
  std::vector<double> coefficients_;  ///< some for each number of the state
  std::vector<double> state_;
};

}  // namespace multibody
