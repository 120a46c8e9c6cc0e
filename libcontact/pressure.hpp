// SPDX-License-Identifier: MIT
#pragma once

/// Pressure over the contact.
// clang-format off
#include "libcontact/pressure/law.hpp"
#include "libcontact/pressure/shaped.hpp"
#include "libcontact/pressure/factory.hpp"
#include "libcontact/pressure/validity.hpp"
// clang-format on
