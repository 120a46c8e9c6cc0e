#pragma once

/// Seats that end: the contact of a ball in a ring, a cup or a socket.
// clang-format off
#include "libcontact/pair/seat_zone.hpp"
#include "libcontact/seat/contact.hpp"
#include "libcontact/seat/table.hpp"
#include "libcontact/seat/moment_set.hpp"
#include "libcontact/seat/joint.hpp"
// clang-format on
