#pragma once

#include <string>

#include "cli/joint/tilted_pins.hpp"
#include "cli/program.hpp"
#include "programs/angle/input.hpp"

namespace hinge_pressure {

/// The command line of hinge-pressure as it was written.
struct Options {
  cli::JointOptions joint = {.use = cli::JointUse::contact};
  hinge_angle::LoadOptions load;
  /// Sweep of the angle between the load and the axis of a seat that ends.
  std::string direction;
  cli::TiltOptions tilt;
  int points = 0;  ///< 0: not given
  bool summary = false;
  cli::OutputOptions output;
};

/// Runs the program. Throws contact::Error for wrong options.
cli::ExitStatus run(const Options& options);

}  // namespace hinge_pressure
