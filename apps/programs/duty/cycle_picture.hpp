#pragma once

#include <string>

#include "libcontact/duty/joint_cycle.hpp"

namespace hinge_duty {

/// Draws reaction, friction moment, and the largest p and p v over the contact.
/// @return "" or the reason why there is no picture
std::string draw_cycle(const contact::JointCycle& cycle,
                       const std::string& title, const std::string& file);

}  // namespace hinge_duty
