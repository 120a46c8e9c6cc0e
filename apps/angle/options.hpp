#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "angle/angle_table.hpp"
#include "cli/program.hpp"

namespace hinge_angle {

/// The command line of hinge-angle as it was written.
struct Options {
  std::string joint;
  std::string pair;
  std::string radius;
  std::string clearance;
  std::string modulus_ratio;
  std::string poisson1 = "0.3";
  std::string poisson2 = "0.3";

  std::string load;
  std::string load_parameter;
  std::string x;
  bool inverse = false;
  std::string theta0;

  // Without these: what the joint file says, or the program's defaults.
  std::vector<std::string> laws;
  std::string limit_angle;
  std::string pressure;
  cli::OutputOptions output;
};

/// Adds the options and the help text to the program.
void add_options(CLI::App& app, Options& options);

/// The joint, laws and limit angle that the options describe. Throws
/// contact::Error if they do not fit together or a value is not allowed.
Setup make_setup(const Options& options);

}  // namespace hinge_angle
