// SPDX-License-Identifier: MIT
#pragma once

/// Half-angle of the contact against load, in both directions.
// clang-format off
#include "libcontact/half_angle/law.hpp"
#include "libcontact/half_angle/factory.hpp"
// clang-format on
