#pragma once

/// Friction integrals and coefficients of a contact.
// clang-format off
#include "libcontact/friction/integrals.hpp"
#include "libcontact/friction/exact.hpp"
#include "libcontact/friction/batch.hpp"
#include "libcontact/friction/any_pressure.hpp"
#include "libcontact/friction/models.hpp"
// clang-format on
