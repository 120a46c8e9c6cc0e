#pragma once

#include <string>
#include <vector>

#include "programs/separation/replay/replay.hpp"
#include "separation/results/run.hpp"

namespace separation {

inline constexpr const char* program_name = "hinge-separation";

/// Warnings: on standard error when they are found, and again in a replay.
class Warnings {
 public:
  /// @param aloud  false: nothing on standard error
  explicit Warnings(bool aloud = true) : aloud_(aloud) {}
  void add(std::string text);
  /// A note, which replays do not show.
  void note(const std::string& text) const;
  const std::vector<std::string>& texts() const { return texts_; }

 private:
  bool aloud_;
  std::vector<std::string> texts_;
};

/// Joints that leave the theory, once for each reason. Says also, as notes, how
/// their fits were read.
void warn_of_joints(const Case& c, Warnings& warnings);

/// Warns of effects of a run that were hardly intended.
void warn_of_run(const Case& c, const Outcome& outcome, Warnings& warnings);

/// Warns of faults of the replay's picture, and gives it all warnings so far.
void warn_of_replay(Replay& replay, Warnings& warnings);

}  // namespace separation
