#pragma once

#include <string>

#include "programs/joint/points/series.hpp"
#include "programs/joint/setup.hpp"

namespace hinge_joint {

/// Draws friction moment, reaction (of states by their contact: normal force)
/// and peak pressure over the time, or the number of the state.
/// @return "" or why there is no picture
std::string draw_points(const Setup& setup, const PointSeries& series,
                        const std::string& file);

}  // namespace hinge_joint
