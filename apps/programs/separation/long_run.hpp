#pragma once

#include <optional>
#include <string>

#include "programs/separation/output/checkpoint.hpp"
#include "separation/results/run.hpp"

namespace separation {

/// Checkpoints of a run.
struct Checkpoints {
  /// File that is written every `every` seconds of the motion; 0 with `resume`:
  /// as often as in that run.
  std::string file = {};
  double every = 0;
  /// File of a checkpoint, and what it says, to go on from.
  std::string resume = {};
  std::optional<Checkpoint> from = {};
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
///   on from is of another run or of a time beyond the end, or the first one
///   not begun
LongRun run_long(const Case& c, RunOptions options,
                 Checkpoints checkpoints = {});

}  // namespace separation
