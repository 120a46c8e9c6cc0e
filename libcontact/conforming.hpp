#pragma once

/// Exact elasticity of the conforming contact of a pin in a hole and a ball in
/// a seat.
// clang-format off
#include "libcontact/conforming/contact_pressure.hpp"
#include "libcontact/conforming/force_point.hpp"
#include "libcontact/conforming/pin.hpp"
#include "libcontact/conforming/ball.hpp"
// clang-format on
