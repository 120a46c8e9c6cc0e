#pragma once

#include "separation/results/output_times.hpp"
#include "separation/results/run.hpp"

namespace separation {

/// The run whose state is restored.
struct StateOwner {
  const Case& of;
  const std::vector<std::string>& columns;
  const OutputTimes& outputs;
  bool rows;  ///< whether rows are kept
};

/// Checks a state except for its motion, which multibody checks.
/// @throws contact::Error unless a run of this case can have it: sizes of
///   arrays, past times, all rows up to its time
void check_state(const RunState& state, const StateOwner& owner);

}  // namespace separation
