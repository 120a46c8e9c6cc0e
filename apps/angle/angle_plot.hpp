#pragma once

#include <string>
#include <vector>

#include "angle/angle_table.hpp"
#include "angle/input.hpp"

namespace hinge_angle {

/// Draws the half-angle of every law over the load. With the law exact among
/// them, a panel below has the others' errors: percent of the exact
/// half-angle at the same load.
/// @return as cli::draw()
std::string draw(const Loads& scale, const Input& input,
                 const cli::Joint& joint, const std::string& file);

}  // namespace hinge_angle
