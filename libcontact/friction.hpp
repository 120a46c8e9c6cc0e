// SPDX-License-Identifier: MIT
#pragma once

/// Friction integrals and coefficients of a contact.
// clang-format off
#include "libcontact/friction/integrals.hpp"
#include "libcontact/friction/friction_integrals.hpp"
// clang-format on
