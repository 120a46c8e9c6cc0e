#pragma once

#include "separation/results/output_times.hpp"
#include "separation/results/run.hpp"

namespace separation {

/// What a state is of.
struct StateOwner {
  const Case& of;
  const std::vector<std::string>& columns;
  const OutputTimes& outputs;
  bool rows;  ///< they are kept
};

/// Looks at all of a state but its motion, which Motion::restore() looks at.
/// @throws contact::Error unless a run of this case may have it: as many of
///   everything, times that are over, all rows up to its own
void check_state(const RunState& state, const StateOwner& owner);

}  // namespace separation
