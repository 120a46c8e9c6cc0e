#pragma once

#include <string>
#include <vector>

#include "separation/simulation/simulation.hpp"

namespace separation {

/// Observations of a force.
struct ForceRecord {
  bool on = false;     ///< it has begun, with stroke left
  bool acted = false;  ///< it has been other than 0
  /// Fault, a sign of unintended action: a number of ForceLaw::faults(), from
  /// 1; 0: none is known.
  int fault = 0;
  double fault_time = 0;  ///< s
};

/// Looks at the forces that there is still something to say of.
/// @param records  one for each force of the case
void look_at_forces(const Simulation& simulation,
                    std::vector<ForceRecord>& records);

/// Faults of forces, a sentence each.
std::vector<std::string> force_faults(const Case& c,
                                      const std::vector<ForceRecord>& records);
/// Forces without effect in a run that has come to its end.
std::vector<std::string> idle_forces(const Case& c, const History& history,
                                     const std::vector<ForceRecord>& records,
                                     double end_time);

}  // namespace separation
