#pragma once

#include <span>

#include "libcontact/duty/pin_cycle.hpp"
#include "libcontact/finite_pin/finite_pin.hpp"
#include "libcontact/joint/pin_lie.hpp"
#include "libcontact/quantities/quantity.hpp"

/// The tables of pins that end, tilt and are relieved.
namespace contact {

std::span<const Quantity<FinitePinSolution>> finite_pin_quantities();
/// Quantities of Joint::lie() that solution_quantities() do not say.
std::span<const Quantity<PinLie>> lie_quantities();
/// The worst of a cycle, and its sums; each is computed when it is asked for.
std::span<const Quantity<PinCycle>> pin_cycle_quantities();

}  // namespace contact
