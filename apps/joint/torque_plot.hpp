#pragma once

#include <string>

#include "joint/input.hpp"
#include "joint/setup.hpp"

namespace hinge_joint {

/// Draws the friction moment over the swept force, a curve for each angle and
/// pair of laws, with the traditional estimate dashed beside it; over the
/// angle if that alone is swept.
/// @return "" or why there is no picture
std::string draw_torque(const Setup& setup, const Inputs& inputs,
                        const std::string& file);

}  // namespace hinge_joint
