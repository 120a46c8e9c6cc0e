#pragma once

#include <string>
#include <vector>

#include "programs/separation/replay/replay.hpp"
#include "separation/results/run.hpp"

namespace separation {

inline constexpr const char* program_name = "hinge-separation";

/// Prints warnings on standard error when they occur, and collects them for a
/// replay.
class Warnings {
 public:
  /// @param aloud  false: prints nothing on standard error
  explicit Warnings(bool aloud = true) : aloud_(aloud) {}
  void add(std::string text);
  /// Prints a note; replays do not show notes.
  void note(const std::string& text) const;
  const std::vector<std::string>& texts() const { return texts_; }

 private:
  bool aloud_;
  std::vector<std::string> texts_;
};

/// Warns of joints outside the limits of the theory, once for each reason.
/// Notes report the clearances taken from fits.
void warn_of_joints(const Case& c, Warnings& warnings);

/// Warns of effects in a run that are probably not intended.
void warn_of_run(const Case& c, const Outcome& outcome, Warnings& warnings);

/// Warns of faults of the replay's picture, and adds all warnings so far to it.
void warn_of_replay(Replay& replay, Warnings& warnings);

}  // namespace separation
