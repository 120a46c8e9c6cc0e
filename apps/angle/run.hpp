#pragma once

#include <string>

#include "angle/input.hpp"
#include "cli/program.hpp"

namespace hinge_angle {

/// The command line of hinge-angle as it was written.
struct Options {
  cli::JointOptions joint = {.use = cli::JointUse::contact};
  LoadOptions load;
  bool compare = false;
  std::string tolerance = "0.1";
  cli::OutputOptions output;
};

/// The whole program. Throws contact::Error for options that are wrong.
cli::ExitStatus run(const Options& options);

}  // namespace hinge_angle
