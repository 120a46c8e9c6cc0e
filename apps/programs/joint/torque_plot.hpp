#pragma once

#include <cstddef>
#include <string>

#include "programs/joint/input.hpp"
#include "programs/joint/setup.hpp"

namespace hinge_joint {

/// Largest number of pairs of half-angle law and pressure law in a picture.
inline constexpr std::size_t most_pairs_of_laws = 8;

/// Draws the friction moment over the force or the angle, whichever has more
/// values. Each pair of laws, and some values of the other variables, have a
/// curve; a dashed curve shows the traditional estimate.
/// @param setup  with at most most_pairs_of_laws
/// @return "" or the reason why there is no picture
std::string draw_torque(const Setup& setup, const Inputs& inputs,
                        const std::string& file);

}  // namespace hinge_joint
