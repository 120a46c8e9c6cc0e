#pragma once

#include <string>

#include "separation/record/record.hpp"
#include "separation/simulation/stop_rule.hpp"

namespace separation {

/// How a case is run.
struct RunOptions {
  FrictionChoice friction = FrictionChoice::full;
  bool rows = true;       ///< keep the time history
  bool clearance = true;  ///< work out distances
  bool progress = false;  ///< say on standard error how far it is
  StopRule stop = {};     ///< none: goes on to its end
  /// Look only at events and at the end; peaks are those of these times.
  bool only_events = false;
  /// File that is written every `checkpoint_every` seconds of the motion; 0
  /// with `resume`: as often as in that run.
  std::string checkpoint = {};
  double checkpoint_every = 0;
  /// Checkpoint to go on from.
  std::string resume = {};
  /// Whatever else makes two runs different, for checkpoints.
  std::string identity = {};
};

/// What has come of a run.
struct Outcome {
  FrictionChoice friction;
  std::string failure;  ///< "" or why it ended before its time
  double end_time;      ///< s
  Recorder::Memory memory;
  multibody::MotionCounts counts;
  std::vector<multibody::HingeMode> modes;  ///< at the end
  History history;                          ///< what had happened by then
  std::string no_checkpoint;  ///< "" or since when and why there is none
};

/// @throws contact::Error if the motion cannot begin, or the checkpoint to go
///   on from cannot be read, is of another run or of a time beyond the end, or
///   the first one not begun
Outcome run_case(const Case& c, const RunOptions& options);

}  // namespace separation
