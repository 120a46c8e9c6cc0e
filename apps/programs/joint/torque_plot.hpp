#pragma once

#include <cstddef>
#include <string>

#include "programs/joint/input.hpp"
#include "programs/joint/setup.hpp"

namespace hinge_joint {

/// Pairs of half-angle law and pressure law whose curves and names fit into a
/// picture.
inline constexpr std::size_t most_pairs_of_laws = 8;

/// Draws the friction moment over the swept force or angle, whichever has more
/// values; a curve for each of some of the others and each pair of laws, with
/// the traditional estimate dashed beside it.
/// @param setup  with at most most_pairs_of_laws
/// @return "" or why there is no picture
std::string draw_torque(const Setup& setup, const Inputs& inputs,
                        const std::string& file);

}  // namespace hinge_joint
