// SPDX-License-Identifier: MIT
#pragma once

/// Pins that end, and tilt: docs/how-to/finite_pin.md.
// clang-format off
#include "libcontact/pair/relief.hpp"
#include "libcontact/finite_pin/finite_pin.hpp"
// clang-format on
