#pragma once

/// Joints with play: the force law of a clearance, impacts, and the joint as a
/// compliant one.
// clang-format off
#include "libcontact/play/force_law.hpp"
// clang-format on
