#pragma once

#include <span>

#include "libcontact/finite_pin/finite_pin.hpp"
#include "libcontact/quantities/quantity.hpp"

/// The table of pins that end, tilt and are relieved.
namespace contact {

std::span<const Quantity<FinitePinSolution>> finite_pin_quantities();

}  // namespace contact
