#pragma once

#include <string>

#include "cli/program.hpp"

/// The parts of the program hinge-fmu.
namespace hinge_fmu {

/// The command line.
struct Options {
  std::string file;    ///< joint or case
  std::string output;  ///< "": derived from the name of the file
  int version = 2;     ///< version of FMI: 2 or 3
};

/// Runs the program. Throws contact::Error for wrong files.
cli::ExitStatus run(const Options& options);

}  // namespace hinge_fmu
