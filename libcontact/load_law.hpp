// SPDX-License-Identifier: MIT
#pragma once

/// Friction that depends on the load, in few numbers and other languages.
// clang-format off
#include "libcontact/load_law/load_law.hpp"
// clang-format on
