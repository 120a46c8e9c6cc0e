#pragma once

/// Many sliding joints tracked side by side; for simulators. Not part of
/// contact.hpp.
// clang-format off
#include "libcontact/tracking/joint_tracker.hpp"
// clang-format on
