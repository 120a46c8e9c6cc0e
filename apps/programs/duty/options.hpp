#pragma once

#include <optional>
#include <string>

#include "cli/joint/friction_options.hpp"
#include "cli/joint/joint_options.hpp"
#include "cli/joint/tilted_pins.hpp"
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
  contact::JointBody force_on = contact::JointBody::body;
  contact::JointBody force_in = contact::JointBody::carrier;
  std::optional<double> wear_seat;        ///< mm^3/(N m)
  std::optional<double> wear_inner;       ///< mm^3/(N m)
  std::optional<double> measured_volume;  ///< mm^3
  std::optional<double> measured_error;   ///< mm^3
  std::optional<double> measured_cycles;
  std::string map;
  std::string map_plot;
  int grid = 2000;
  std::optional<double> cycles;
  std::string blocks;
  std::string worn;      ///< to begin with
  std::string worn_out;  ///< after all cycles
  std::string states;
  /// Whether the contacts of joints with a seat go on beyond its rims.
  bool without_seat = false;
  std::string seat_table;  ///< file of the kept table of contacts at rims
  cli::TiltOptions tilt;   ///< lie of a pin that ends, one value
  /// Files of it: p v along it, its wear over length and angle.
  std::string along;
  std::string along_map;
  cli::OutputOptions output;
};

}  // namespace hinge_duty
