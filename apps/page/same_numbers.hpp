#pragma once

#include <string>

#include "programs/joint/state.hpp"

namespace page {

/// Other ways to compute the numbers of the page, each with the joint file in
/// joint.toml.
struct SameNumbers {
  std::string command;
  std::string python;
  std::string cpp;
};

/// @param input   the given numbers
/// @param is_pin  pins have no angle between reaction and rate
/// @param has_seat  which the page leaves out
SameNumbers same_numbers(const hinge_joint::Input& input, bool is_pin,
                         bool has_seat);

}  // namespace page
