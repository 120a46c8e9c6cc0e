// SPDX-License-Identifier: MIT
#pragma once

/// Seats that end: the contact of a ball in a ring, a cup or a socket.
// clang-format off
#include "libcontact/pair/seat_zone.hpp"
#include "libcontact/seat/contact.hpp"
#include "libcontact/seat/table.hpp"
// clang-format on
