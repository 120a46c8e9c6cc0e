#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "libcontact/duty/duty_cycle.hpp"
#include "programs/duty/options.hpp"

namespace hinge_duty {

/// A cycle's file.
struct CycleFile {
  contact::DutyCycle cycle;
  /// How a pin that ends lies at the times of the cycle, if there are columns
  /// of it: tilts, rad, or places of the load, m.
  std::vector<Eigen::Vector2d> tilts = {};
  std::vector<double> places = {};
  std::string lie_column = {};  ///< the first of them
};

/// The cycle of --cycle, --period, --euler, --force-on and --force-in. Throws
/// contact::Error if they do not fit together or a line of the file is bad.
CycleFile read_cycle(const Options& options, bool is_pin);

}  // namespace hinge_duty
