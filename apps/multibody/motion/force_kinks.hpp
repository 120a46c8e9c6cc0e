#pragma once

#include <optional>
#include <span>
#include <vector>

#include "multibody/motion/crossings.hpp"
#include "multibody/motion/equations.hpp"
#include "multibody/motion/stepper.hpp"

namespace multibody {

/// Kinks of the forces over the bodies' places (ForceModel::add_kinks()) within
/// a step. A step between two kinks covers one smooth piece, so that features
/// narrower than a step are not missed.
class ForceKinks {
 public:
  /// Keeps references to both arguments.
  ForceKinks(const Equations& equations, MotionSample& view)
      : equations_(equations), view_(view) {}

  /// First time before the end of the last step at which a kink is passed.
  /// Kinks at the beginning or end of the step, to 1e-10 of their place (of 1
  /// rad or 1 m if it is less), do not count: forces are continuous there.
  std::optional<double> first(Stepper& stepper);

 private:
  /// A variable with its values in the last step.
  struct Track {
    std::span<const double> kinks;
    StepFunction::Values values;
    double soon;  ///< value just after the beginning
  };
  bool sample(Stepper& stepper);
  std::optional<double> leaves(Stepper& stepper, std::size_t variable);
  std::optional<double> passes(Stepper& stepper, std::size_t variable,
                               double kink, double before);

  const Equations& equations_;
  MotionSample& view_;
  std::vector<KinkedVariable> now_;
  std::vector<Track> tracks_;
};

}  // namespace multibody
