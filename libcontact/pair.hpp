// SPDX-License-Identifier: MIT
#pragma once

/// The two surfaces of a joint: elastic constants, radius, clearance and fit,
/// friction, and where the force enters.
// clang-format off
#include "libcontact/pair/material.hpp"
#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/fit.hpp"
#include "libcontact/pair/spherical_bearing.hpp"
#include "libcontact/pair/friction_stress.hpp"
#include "libcontact/pair/friction_law.hpp"
#include "libcontact/pair/inner_loading.hpp"
#include "libcontact/pair/layers.hpp"
#include "libcontact/pair/temperatures.hpp"
#include "libcontact/pair/contact_conditions.hpp"
// clang-format on
