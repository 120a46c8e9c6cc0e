#pragma once

#include <span>

#include "libcontact/quantities/quantity.hpp"
#include "libcontact/seat/joint.hpp"

/// The tables of seats that end.
namespace contact {

/// Quantities of a SeatState, or of Joint::rims() alone.
std::span<const Quantity<RimContact>> seat_quantities();
/// Quantities of Joint::rims() that solution_quantities() do not say.
std::span<const Quantity<RimContact>> rim_quantities();
/// With those of its contact.
std::span<const Quantity<SeatJointSolution>> seat_joint_quantities();
/// With those of the sliding at the limit.
std::span<const Quantity<SeatRestSolution>> seat_rest_quantities();
std::span<const Quantity<SeatPv>> seat_pv_quantities();

}  // namespace contact
