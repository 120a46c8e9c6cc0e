#pragma once

#include <string>
#include <vector>

#include "separation/record/run.hpp"

namespace separation {

inline constexpr const char* program_name = "hinge-separation";

/// What is said on standard error as it is found, and again in a replay.
class Warnings {
 public:
  void add(std::string text);
  const std::vector<std::string>& texts() const { return texts_; }

 private:
  std::vector<std::string> texts_;
};

/// Joints that leave the theory, once for each reason. Says also, as notes, how
/// their fits were read.
void warn_of_joints(const Case& c, Warnings& warnings);

/// What has come of a run and was hardly meant.
void warn_of_run(const Case& c, const Outcome& outcome, Warnings& warnings);

}  // namespace separation
