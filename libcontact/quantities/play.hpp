// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "libcontact/play/impact.hpp"
#include "libcontact/play/play_joint.hpp"
#include "libcontact/quantities/quantity.hpp"

/// The tables of joints with play.
namespace contact {

std::span<const Quantity<ForceState>> force_state_quantities();
std::span<const Quantity<Impact>> impact_quantities();
std::span<const Quantity<PlayForce>> play_force_quantities();

}  // namespace contact
