#pragma once

#include <string>
#include <vector>

#include "programs/separation/replay/scene.hpp"
#include "separation/results/run.hpp"

/// Replays as a page or a glTF file.
namespace separation {

/// A run and its place in a comparison.
struct ShownRun {
  std::string name;  ///< "" for a single run
  const Outcome* outcome;
  /// The run's own case if its numbers differ from the replay's case.
  const Case* of = nullptr;
};

/// Content of a replay: one or two runs of a case; the second one is drawn
/// faint.
struct Replay {
  const Case& c;
  std::vector<ShownRun> runs;
  std::vector<std::string> warnings;
  std::string case_text;  ///< "" leaves it out
};

/// Shows one row in `every`, and all rows at events.
std::vector<Take> takes_of(const Replay& replay, int every);

/// Animated glTF, all rows.
std::string replay_glb(const Replay& replay);

/// Faults of the picture: bodies without shapes, and rotations too fast for the
/// spacing of the rows.
std::vector<std::string> replay_faults(const Replay& replay);

}  // namespace separation
