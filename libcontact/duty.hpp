// SPDX-License-Identifier: MIT
#pragma once

/// Wear and heat of a joint: p v, heat flux, duty cycles, wear maps.
// clang-format off
#include "libcontact/duty/sliding_contact.hpp"
#include "libcontact/duty/duty_cycle.hpp"
#include "libcontact/duty/joint_cycle.hpp"
#include "libcontact/duty/joint_rating.hpp"
#include "libcontact/duty/wear_map.hpp"
#include "libcontact/duty/wear_in.hpp"
#include "libcontact/duty/along_pin.hpp"
#include "libcontact/duty/lies.hpp"
// clang-format on
