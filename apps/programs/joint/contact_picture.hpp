#pragma once

#include <string>

#include "programs/joint/solution_row.hpp"

namespace hinge_joint {

/// Draws p, p v and the slip over the contact of one state, and marks the
/// largest p and p v. A ball is seen from outside, from above the contact's
/// centre, in an equal-area projection; for a pin they are drawn over the
/// angle.
/// @param title  name of the joint
/// @return "" or the reason why there is no picture
std::string draw_contact(const NamedJoint& joint, const Answer& answer,
                         const std::string& title, const std::string& file);

}  // namespace hinge_joint
