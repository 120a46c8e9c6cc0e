#pragma once

/// Many sliding joints followed side by side; for simulators. Not part of
/// contact.hpp.
// clang-format off
#include "libcontact/tracking/joint_follower.hpp"
// clang-format on
