#pragma once

#include <optional>
#include <string>

#include "programs/separation/output/checkpoint.hpp"
#include "separation/results/run.hpp"

namespace separation {

/// Options of checkpoints.
struct Checkpoints {
  /// File written every `every` seconds of the simulated motion; with `resume`,
  /// 0 means as often as in that run.
  std::string file = {};
  double every = 0;
  /// Checkpoint file to resume from, and its content.
  std::string resume = {};
  std::optional<Checkpoint> from = {};
  /// Text that identifies the run: it differs if two runs differ.
  std::string identity = {};
};

struct LongRun {
  Outcome outcome;
  std::string no_checkpoint;  ///< "", or since when and why none is written
};

/// Runs a case to its end, or as far as possible, and reports progress on
/// standard error.
/// @throws contact::Error if the motion cannot begin, if the checkpoint belongs
///   to another run or lies beyond the end, or if the first checkpoint cannot
///   be begun
LongRun run_long(const Case& c, RunOptions options,
                 Checkpoints checkpoints = {});

}  // namespace separation
