#pragma once

#include <string>
#include <vector>

#include "programs/separation/replay/replay.hpp"
#include "separation/results/run.hpp"

namespace separation {

inline constexpr const char* program_name = "hinge-separation";

/// What is said on standard error as it is found, and again in a replay.
class Warnings {
 public:
  /// @param aloud  false: nothing on standard error
  explicit Warnings(bool aloud = true) : aloud_(aloud) {}
  void add(std::string text);
  /// What a replay does not say.
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

/// What the replay cannot show as it is. It gets this and all warnings before.
void warn_of_replay(Replay& replay, Warnings& warnings);

}  // namespace separation
