#pragma once

#include <span>

#include "libcontact/quantities/quantity.hpp"
#include "libcontact/seat/joint.hpp"

/// The tables of seats that end.
namespace contact {

std::span<const Quantity<SeatState>> seat_quantities();
/// Beside those of the contact.
std::span<const Quantity<SeatJointSolution>> seat_joint_quantities();

}  // namespace contact
