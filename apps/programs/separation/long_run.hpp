#pragma once

#include <string>

#include "separation/results/run.hpp"

namespace separation {

/// Checkpoints of a run.
struct Checkpoints {
  /// File that is written every `every` seconds of the motion; 0 with `resume`:
  /// as often as in that run.
  std::string file = {};
  double every = 0;
  /// Checkpoint to go on from.
  std::string resume = {};
  /// Whatever makes two runs different.
  std::string identity = {};
};

struct LongRun {
  Outcome outcome;
  std::string no_checkpoint;  ///< "" or since when and why there is none
};

/// Runs a case to its end, or as far as it comes. Says on standard error how
/// far it is.
/// @throws contact::Error if the motion cannot begin, or the checkpoint to go
///   on from cannot be read, is of another run or of a time beyond the end, or
///   the first one not begun
LongRun run_long(const Case& c, RunOptions options,
                 const Checkpoints& checkpoints = {});

}  // namespace separation
