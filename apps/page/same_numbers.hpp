#pragma once

#include <string>
#include <string_view>

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
/// @param left_out  "seat" or "relief", which the page leaves out; "" for none
SameNumbers same_numbers(const hinge_joint::Input& input, bool is_pin,
                         std::string_view left_out);

}  // namespace page
