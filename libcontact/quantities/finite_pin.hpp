// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "libcontact/joint/pin_lie.hpp"
#include "libcontact/quantities/quantity.hpp"

namespace contact {

/// Quantities of pins that end, Joint::lie(), that solution_quantities() do not
/// say.
std::span<const Quantity<PinLie>> lie_quantities();

}  // namespace contact
