// SPDX-License-Identifier: MIT
#pragma once

/// Friction parameters from measured moments, and for other programs.
// clang-format off
#include "libcontact/identify/identify.hpp"
#include "libcontact/identify/equivalent.hpp"
// clang-format on
