#pragma once

#include <string>

#include "cli/joint/friction_options.hpp"
#include "cli/joint/joint_options.hpp"
#include "cli/program.hpp"

/// The parts of the program hinge-duty.
namespace hinge_duty {

/// The command line as it was written; "" for options that were not given.
struct Options {
  cli::JointOptions joint = {.use = cli::JointUse::friction};
  cli::FrictionOptions friction;
  std::string cycle;
  std::string period;
  std::string euler;
  std::string force_columns;
  std::string angle_columns;
  std::string force_on;
  std::string force_in;
  std::string wear_seat;
  std::string wear_inner;
  std::string measured_volume;
  std::string measured_error;
  std::string measured_cycles;
  std::string map;
  std::string map_plot;
  std::string grid;
  std::string cycles;
  std::string blocks;
  std::string states;
  cli::OutputOptions output;
};

}  // namespace hinge_duty
