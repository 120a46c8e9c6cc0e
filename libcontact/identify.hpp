#pragma once

/// Friction parameters from measured moments.
// clang-format off
#include "libcontact/identify/measured.hpp"
#include "libcontact/identify/identify.hpp"
// clang-format on
