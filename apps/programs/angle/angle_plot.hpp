#pragma once

#include <string>
#include <vector>

#include "programs/angle/angle_table.hpp"
#include "programs/angle/input.hpp"

namespace hinge_angle {

/// Draws the half-angle of every joint and law over the load. For a single
/// joint whose laws include exact, a panel below shows the errors of the
/// others: percent of the exact half-angle at the same load.
/// @param inputs  one for each joint
/// @return as cli::draw()
std::string draw(const std::vector<Input>& inputs,
                 const std::vector<cli::Joint>& joints,
                 const std::string& file);

/// Throws contact::Error if a picture of these joints needs too many curves.
void check_curves(const std::vector<cli::Joint>& joints);

}  // namespace hinge_angle
