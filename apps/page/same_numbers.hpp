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
/// @param has_seat, has_relief  which the page leaves out; hinge-joint has no
///                              option for a joint without its relief
SameNumbers same_numbers(const hinge_joint::Input& input, bool is_pin,
                         bool has_seat, bool has_relief);

}  // namespace page
