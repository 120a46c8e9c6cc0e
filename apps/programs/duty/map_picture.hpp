#pragma once

#include <string>
#include <vector>

#include "programs/duty/body_wear.hpp"

namespace hinge_duty {

/// Draws the integral of p v over both bodies: of a ball seen from outside,
/// straight above the middle of the wear, with equal areas; of a pin over beta.
/// @param wear  of both bodies
/// @return "" or why there is no picture
std::string draw_map(bool is_pin, const std::vector<BodyWear>& wear,
                     const std::string& title, const std::string& file);

}  // namespace hinge_duty
