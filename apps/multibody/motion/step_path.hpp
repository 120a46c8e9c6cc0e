#pragma once

#include <vector>

#include "multibody/motion/equations.hpp"
#include "multibody/motion/stepper.hpp"

namespace multibody {

/// Positions of single bodies within the last step, for many queries: dense
/// output as polynomials, computed once a step on first use.
class StepPath {
 public:
  /// Keeps references to both arguments.
  StepPath(const Equations& equations, Stepper& stepper)
      : equations_(equations), stepper_(stepper) {}

  /// The carrier (0) or a body (1 +) at a time of the step, equal to dense
  /// output to rounding; a released body has no hinge angle.
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
