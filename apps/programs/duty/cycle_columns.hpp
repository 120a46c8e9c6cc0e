#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/stream/points.hpp"
#include "libcontact/base/units.hpp"
#include "programs/duty/options.hpp"
#include "programs/duty/sto_header.hpp"

namespace hinge_duty {

/// Names and places of the columns of a cycle's file: the time, three columns
/// of the force, the columns of the motion and, for a pin, the columns of its
/// tilt or of the load's place.
struct CycleColumns {
  std::vector<std::string> names = {"time_s", "R_x_N", "R_y_N", "R_z_N"};
  static constexpr std::size_t motion_at = 4;
  std::size_t motion_end = motion_at;
  /// Places of the columns with the tilt of a finite-length pin; 0 for none.
  std::size_t tilt_x_at = 0;
  std::size_t tilt_y_at = 0;
  std::size_t load_at = 0;
  std::vector<cli::PointColumn> needed;
  cli::PointHeader header;
  bool is_angles = false;
  double angle_unit = contact::degree;
  std::optional<StoHeader> sto;
};

/// Reads the header of a file.
/// @throws contact::Error if columns are missing or options do not fit them
CycleColumns read_columns(cli::LineReader& reader, const Options& options,
                          bool is_pin);

}  // namespace hinge_duty
