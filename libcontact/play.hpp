// SPDX-License-Identifier: MIT
#pragma once

/// Joints with play: the force law of a clearance, impacts, and the joint as a
/// compliant one.
// clang-format off
#include "libcontact/play/force_law.hpp"
#include "libcontact/play/hunt_crossley.hpp"
#include "libcontact/play/impact.hpp"
#include "libcontact/play/published_forces.hpp"
#include "libcontact/play/play_joint.hpp"
// clang-format on
