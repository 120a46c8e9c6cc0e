#pragma once

#include "cli/joint/tilted_pins.hpp"
#include "cli/program.hpp"
#include "programs/angle/input.hpp"
#include "programs/angle/play.hpp"

namespace hinge_angle {

/// The command line of hinge-angle as it was written.
struct Options {
  cli::JointOptions joint = {.use = cli::JointUse::contact};
  LoadOptions load;
  PlayOptions play;
  cli::TiltOptions tilt;
  bool compare = false;
  bool inverse = false;
  double tolerance = 0.1;  ///< percent
  cli::OutputOptions output;
};

/// Runs the program. Throws contact::Error for wrong options.
cli::ExitStatus run(const Options& options);

}  // namespace hinge_angle
