#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/program.hpp"

namespace study {

/// The command line of hinge-study.
struct Options {
  std::string file;
  int runs = 0;  ///< 0: the file's
  std::optional<int> seed;
  std::string rows;  ///< "A:B"
  std::string journal;
  std::vector<std::string> merge;
  bool check = false;
  bool quantities = false;
  std::optional<int> run;
  std::string history;
  std::string csv;
  std::string hdf5;
  cli::OutputOptions output;
};

cli::ExitStatus run(const Options& options);

}  // namespace study
