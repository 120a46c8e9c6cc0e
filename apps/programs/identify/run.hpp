#pragma once

#include <optional>
#include <string>

#include "cli/joint/friction_options.hpp"
#include "cli/joint/joint_options.hpp"
#include "cli/program.hpp"

/// The parts of the program hinge-identify.
namespace hinge_identify {

/// The command line as it was written; "" for options that were not given.
struct Options {
  cli::JointOptions joint = {.use = cli::JointUse::friction};
  std::string data;
  std::string fit = "f0,A";
  cli::FrictionOptions friction;
  std::optional<double> rate;       ///< rad/s
  std::optional<double> sigma_abs;  ///< N m
  std::optional<double> sigma_rel;
  double level = 0.95;
  bool huber = false;
  bool profile = false;
  std::string residuals;
  cli::OutputOptions output;
};

/// Runs the program. Throws contact::Error for wrong options.
cli::ExitStatus run(const Options& options);

}  // namespace hinge_identify
