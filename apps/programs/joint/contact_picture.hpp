#pragma once

#include <string>

#include "programs/joint/solution_row.hpp"

namespace hinge_joint {

/// Draws p, p v and the slip over the contact of one state, p and p v with
/// their largest values marked: of a ball seen from outside, straight above
/// the contact's centre, with equal areas; of a pin over the angle.
/// @param title  name of the joint
/// @return "" or why there is no picture
std::string draw_contact(const NamedJoint& joint, const Answer& answer,
                         const std::string& title, const std::string& file);

}  // namespace hinge_joint
