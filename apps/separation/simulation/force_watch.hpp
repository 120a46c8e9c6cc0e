// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "separation/simulation/simulation.hpp"

namespace separation {

/// Observations of a force.
struct ForceRecord {
  bool on = false;     ///< it has begun, with remaining stroke
  bool acted = false;  ///< it has been nonzero
  /// Fault, a sign of unintended action: a number of ForceLaw::faults(), from
  /// 1; 0: none known.
  int fault = 0;
  double fault_time = 0;  ///< s
};

/// Checks the forces whose records may still change.
/// @param records  one for each force of the case
void look_at_forces(const Simulation& simulation,
                    std::vector<ForceRecord>& records);

/// Faults of forces, a sentence each.
std::vector<std::string> force_faults(const Case& c,
                                      const std::vector<ForceRecord>& records);
/// Forces without effect in a finished run.
std::vector<std::string> idle_forces(const Case& c, const History& history,
                                     const std::vector<ForceRecord>& records,
                                     double end_time);

}  // namespace separation
