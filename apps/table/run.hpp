#pragma once

#include <string>

#include "cli/program.hpp"

namespace hinge_table {

/// The command line of hinge-table as it was written.
struct Options {
  std::string theta0;
  std::string alpha;
  std::string points;
  std::string method = "exact";
  // Of markdown, latex and pictures; without it chi.
  std::string quantity;
  // Of the method quadrature; without it 1e-10.
  std::string tolerance;
  // Without it: the joint file's, or cosine.
  std::string pressure;
  std::string loading;
  // Of the materials, one of these three.
  std::string joint;
  std::string pair;
  std::string modulus_ratio;
  std::string poisson1 = "0.3";
  std::string poisson2 = "0.3";
  cli::OutputOptions output;
};

/// The whole program. Throws contact::Error for options that are wrong.
cli::ExitStatus run(const Options& options);

}  // namespace hinge_table
