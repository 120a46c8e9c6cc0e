#pragma once

#include <string>
#include <vector>

#include "programs/duty/body_wear.hpp"

namespace hinge_duty {

/// Draws the integral of p v over both bodies: a ball is seen from outside,
/// from above the middle of the wear, in an equal-area projection; for a pin
/// the integral is drawn over beta.
/// @param wear  of both bodies
/// @return "" or the reason why there is no picture
std::string draw_map(bool is_pin, const std::vector<BodyWear>& wear,
                     const std::string& title, const std::string& file);

}  // namespace hinge_duty
