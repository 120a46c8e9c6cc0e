#pragma once

#include <string>
#include <vector>

#include "separation/simulation/simulation.hpp"

namespace separation {

/// What has been seen of a force.
struct ForceRecord {
  bool on = false;     ///< it has begun, with stroke left
  bool acted = false;  ///< it has been other than 0
  /// What it does is hardly what was meant.
  enum class Fault {
    none,
    /// A pusher: its point on the body is behind that on the carrier.
    behind,
    /// A pusher of a free body: ahead of it is the carrier's centre of mass,
    /// and behind it the body's.
    inwards,
    /// A spring with a free length: its points are in one place.
    no_direction,
    /// A spring: longer than its free length when the body has come off.
    pulls_back
  } fault = Fault::none;
  double fault_time = 0;  ///< s
};

/// Looks at the forces that there is still something to say of.
/// @param records  one for each force of the case
void look_at_forces(const Simulation& simulation,
                    std::vector<ForceRecord>& records);

/// What is wrong with forces, a sentence each.
std::vector<std::string> force_faults(const Case& c,
                                      const std::vector<ForceRecord>& records);
/// What has not acted in a run that has come to its end.
std::vector<std::string> idle_forces(const Case& c, const History& history,
                                     const std::vector<ForceRecord>& records,
                                     double end_time);

}  // namespace separation
