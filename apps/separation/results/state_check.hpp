#pragma once

#include "separation/results/output_times.hpp"
#include "separation/results/run.hpp"

namespace separation {

/// The run that a state is to be restored to.
struct StateOwner {
  const Case& of;
  const std::vector<std::string>& columns;
  const OutputTimes& outputs;
  bool rows;  ///< they are kept
};

/// Checks all of a state but its motion, which multibody checks.
/// @throws contact::Error unless a run of this case may have it: as many of
///   everything, times that are over, all rows up to its own
void check_state(const RunState& state, const StateOwner& owner);

}  // namespace separation
