#pragma once

#include <string>
#include <vector>

#include "cli/program.hpp"

namespace separation {

/// The command line of hinge-separation.
struct Options {
  std::string case_file;
  std::string history;  ///< file name, "" for none
  std::string events;
  bool compare = false;
  std::string friction;               ///< "": as in the case
  double end_time = 0;                ///< s; 0: as in the case
  std::vector<std::string> settings;  ///< KEY=VALUE
  std::string half_angle_law;
  std::string pressure_law;
  bool no_clearance = false;
  std::string checkpoint;
  double checkpoint_every = 0;  ///< s
  std::string resume;
  std::vector<std::string> replays;  ///< .glb, .html
  bool no_case = false;              ///< leaves the case out of the .html
  int step_limit = 0;                ///< 0: none
  double time_limit = 0;             ///< s of wall-clock time; 0: none
  cli::OutputOptions output;
};

/// Runs the program. Throws contact::Error for wrong options and files.
cli::ExitStatus run(const Options& options);

}  // namespace separation
