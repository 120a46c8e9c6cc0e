#pragma once

#include <string>

#include "cli/program.hpp"

/// The parts of the program hinge-fmu.
namespace hinge_fmu {

/// The command line.
struct Options {
  std::string file;    ///< joint or case
  std::string output;  ///< "": named after the file
  int version = 2;     ///< 2 or 3: of FMI
};

/// The whole program. Throws contact::Error for files that are wrong.
cli::ExitStatus run(const Options& options);

}  // namespace hinge_fmu
