// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "libcontact/joint/rim_contact.hpp"
#include "libcontact/quantities/quantity.hpp"

/// The tables of seats that end.
namespace contact {

/// Quantities of a SeatState, or of Joint::rims() alone.
std::span<const Quantity<RimContact>> seat_quantities();
/// Quantities of Joint::rims() that solution_quantities() do not say.
std::span<const Quantity<RimContact>> rim_quantities();

}  // namespace contact
