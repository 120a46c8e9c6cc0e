#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/program.hpp"

namespace study {

/// The command line of hinge-study.
struct Options {
  std::string file;
  int runs = 0;  ///< 0: as in the file
  std::optional<int> seed;
  std::string rows;  ///< "A:B"
  std::string journal;
  std::vector<std::string> merge;
  bool check = false;
  bool quantities = false;
  int parts = 0;  ///< 0: not given
  std::optional<int> run;
  std::string history;
  std::string csv;
  std::string hdf5;
  std::string report;  ///< .html
  cli::OutputOptions output;
};

cli::ExitStatus run(const Options& options);

}  // namespace study
