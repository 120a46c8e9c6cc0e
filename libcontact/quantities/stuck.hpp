// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "libcontact/joint/presliding/stuck_joint.hpp"
#include "libcontact/quantities/quantity.hpp"

namespace contact {

/// Quantities of joints that friction holds, stuck_joint().
std::span<const Quantity<StuckJoint>> stuck_quantities();

}  // namespace contact
