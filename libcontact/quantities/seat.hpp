#pragma once

#include <span>

#include "libcontact/quantities/quantity.hpp"
#include "libcontact/seat/contact.hpp"

/// The table of seats that end.
namespace contact {

std::span<const Quantity<SeatState>> seat_quantities();

}  // namespace contact
