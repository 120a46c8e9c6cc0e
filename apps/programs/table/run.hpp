#pragma once

#include <string>

#include "cli/joint/joint_options.hpp"
#include "cli/program.hpp"
#include "programs/table/method.hpp"

namespace hinge_table {

/// The command line of hinge-table as it was written.
struct Options {
  std::string theta0;
  std::string alpha;
  std::string points;
  std::string method = "exact";
  // For Markdown, LaTeX and pictures; chi by default.
  std::string quantity;
  // Numbers of bodies, for the quantity operations; 1 to 8 by default.
  std::string bodies;
  // For the method quadrature; 1e-10 by default.
  std::string tolerance;
  cli::JointOptions joint = {.use = cli::JointUse::pressure};
  cli::OutputOptions output;
};

/// Runs the program. Throws contact::Error for wrong options.
cli::ExitStatus run(const Options& options);
/// Runs the program with a known method.
/// @param joint  its name, for pictures
cli::ExitStatus run(const Options& options, const Method& method,
                    const std::string& joint);

}  // namespace hinge_table
