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
  std::string worn;      ///< wear at the beginning
  std::string worn_out;  ///< wear after all cycles
  std::string states;
  /// True: the contacts of joints with a seat extend beyond its rims.
  bool without_seat = false;
  std::string seat_table;  ///< file that keeps the table of contacts at rims
  cli::TiltOptions tilt;   ///< one tilt of a finite-length pin
  /// Files for a finite-length pin: p v along it, wear over length and angle.
  std::string along;
  std::string along_map;
  cli::OutputOptions output;
};

}  // namespace hinge_duty
