#pragma once

#include <string>
#include <vector>

#include "separation/record/run.hpp"
#include "separation/replay/replay.hpp"

namespace separation {

inline constexpr const char* program_name = "hinge-separation";

/// What is said on standard error as it is found, and again in a replay.
class Warnings {
 public:
  /// @param aloud  false: in the replay only
  explicit Warnings(bool aloud = true) : aloud_(aloud) {}
  void add(std::string text);
  /// Of no replay.
  void note(const std::string& text) const;
  const std::vector<std::string>& texts() const { return texts_; }

 private:
  bool aloud_;
  std::vector<std::string> texts_;
};

/// Joints that leave the theory, once for each reason. Says also, as notes, how
/// their fits were read.
void warn_of_joints(const Case& c, Warnings& warnings);

/// What has come of a run and was hardly meant.
void warn_of_run(const Case& c, const Outcome& outcome, Warnings& warnings);

/// What it cannot show, and gives it all warnings.
void warn_of_replay(Replay& replay, Warnings& warnings);

}  // namespace separation
