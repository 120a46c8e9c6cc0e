#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "libcontact/duty/duty_cycle.hpp"
#include "programs/duty/options.hpp"

namespace hinge_duty {

/// A cycle read from a file.
struct CycleFile {
  contact::DutyCycle cycle;
  /// Positions of a finite-length pin at the times of the cycle, if the file
  /// has such columns: tilts, rad, or places of the load, m.
  std::vector<Eigen::Vector2d> tilts = {};
  std::vector<double> places = {};
  std::string lie_column = {};  ///< first of these columns
};

/// The cycle of --cycle, --period, --euler, --force-on and --force-in. Throws
/// contact::Error if options conflict or a line of the file is bad.
CycleFile read_cycle(const Options& options, bool is_pin);

}  // namespace hinge_duty
