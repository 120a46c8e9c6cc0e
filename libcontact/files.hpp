// SPDX-License-Identifier: MIT
#pragma once

/// Materials and joints from TOML files: library contact::files.
// clang-format off
#include "libcontact/files/setting.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/files/worn_seat_file.hpp"
// clang-format on
