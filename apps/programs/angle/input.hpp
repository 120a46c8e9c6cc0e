#pragma once

#include <string>

#include "cli/joint/joint_options.hpp"
#include "cli/sweep.hpp"
#include "programs/angle/loads.hpp"

namespace hinge_angle {

/// Swept variable on the command line, as it was written.
struct LoadOptions {
  std::string load;
  std::string load_parameter;
  std::string x;
  std::string theta0;

  bool given() const {
    return !load.empty() || !load_parameter.empty() || !x.empty() ||
           !theta0.empty();
  }
};

/// Adds --load, --load-parameter and --x.
void add_load_options(cli::Program& program, LoadOptions& options);

/// Sweep of a load in one of its variables, or of the half-angle.
struct Input {
  LoadVariable variable;
  bool inverse;
  cli::Sweep values;
};

/// Sweep given by the options. Throws contact::Error if there is none or a
/// value is not allowed.
Input make_input(const LoadOptions& options, const cli::Joint& joint);

}  // namespace hinge_angle
