// SPDX-License-Identifier: MIT
#pragma once

/// Quantities of results: keys, symbols, dimensions and meanings.
// clang-format off
#include "libcontact/quantities/quantity.hpp"
#include "libcontact/quantities/tables.hpp"
#include "libcontact/quantities/seat.hpp"
#include "libcontact/quantities/finite_pin.hpp"
#include "libcontact/quantities/play.hpp"
#include "libcontact/quantities/fit.hpp"
#include "libcontact/quantities/stuck.hpp"
// clang-format on
