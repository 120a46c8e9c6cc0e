#pragma once

#include <string>

#include "angle/setup.hpp"
#include "cli/program.hpp"

namespace hinge_pressure {

/// The command line of hinge-pressure as it was written.
struct Options {
  /// Joint, load, half-angle law, limit angle, output.
  hinge_angle::Options contact;
  std::vector<std::string> pressures;
  std::string points = "101";
  bool summary = false;
};

/// The whole program. Throws contact::Error for options that are wrong.
cli::ExitStatus run(const Options& options);

}  // namespace hinge_pressure
