#pragma once

#include <string>
#include <vector>

#include "programs/separation/replay/scene.hpp"
#include "separation/results/run.hpp"

/// What a replay shows, in a page or a glTF file.
namespace separation {

/// A run and its place in a comparison.
struct ShownRun {
  std::string name;  ///< "" for the only one
  const Outcome* outcome;
  /// Its own case if numbers differ from those of the replay's.
  const Case* of = nullptr;
};

/// What is written of one or of two runs of a case; the second one is faint.
struct Replay {
  const Case& c;
  std::vector<ShownRun> runs;
  std::vector<std::string> warnings;
  std::string case_text;  ///< "" leaves it out
};

/// Of rows one in `every`, and all about events.
std::vector<Take> takes_of(const Replay& replay, int every);

/// Animated glTF, all rows.
std::string replay_glb(const Replay& replay);

/// What cannot be shown as it is: bodies without shapes, turns that are too
/// fast for the rows.
std::vector<std::string> replay_faults(const Replay& replay);

}  // namespace separation
