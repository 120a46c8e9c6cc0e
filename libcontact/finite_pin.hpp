#pragma once

/// Pins that end, and tilt: docs/finite_pin.md.
// clang-format off
#include "libcontact/finite_pin/relief.hpp"
#include "libcontact/finite_pin/finite_pin.hpp"
// clang-format on
