#pragma once

#include <string>
#include <vector>

#include "programs/angle/angle_table.hpp"
#include "programs/angle/input.hpp"

namespace hinge_angle {

/// Draws the half-angle of every joint and law over the load. If the only joint
/// has the law exact among others, a panel below has the others' errors:
/// percent of the exact half-angle at the same load.
/// @param inputs  one for each joint
/// @return as cli::draw()
std::string draw(const std::vector<Input>& inputs,
                 const std::vector<cli::Joint>& joints,
                 const std::string& file);

/// Throws contact::Error if a picture of them would have too many curves.
void check_curves(const std::vector<cli::Joint>& joints);

}  // namespace hinge_angle
