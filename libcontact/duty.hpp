#pragma once

/// What wears and heats a joint: p v, heat flux, duty cycles, wear maps.
// clang-format off
#include "libcontact/duty/sliding_contact.hpp"
// clang-format on
