#pragma once

#include <string>

#include "programs/joint/points/series.hpp"
#include "programs/joint/setup.hpp"

namespace hinge_joint {

/// Draws friction moment, reaction (normal force if states give it) and peak
/// pressure over the time, or over the number of the state.
/// @return "" or the reason why there is no picture
std::string draw_points(const Setup& setup, const PointSeries& series,
                        const std::string& file);

}  // namespace hinge_joint
