#pragma once

#include <string>

#include "cli/joint/joint_options.hpp"
#include "cli/program.hpp"

/// The parts of the program hinge-identify.
namespace hinge_identify {

/// The command line as it was written; "" for options that were not given.
struct Options {
  cli::JointOptions joint = {.use = cli::JointUse::friction};
  std::string data;
  std::string fit = "f0,A";
  std::string friction;
  std::string adhesion;
  std::string rate;
  std::string sigma_abs;
  std::string sigma_rel;
  double level = 0.95;
  bool huber = false;
  bool profile = false;
  std::string residuals;
  cli::OutputOptions output;
};

/// The whole program. Throws contact::Error for options that are wrong.
cli::ExitStatus run(const Options& options);

}  // namespace hinge_identify
