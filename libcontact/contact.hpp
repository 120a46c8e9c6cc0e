// SPDX-License-Identifier: MIT
#pragma once

/// libcontact in physics order: each stage includes only earlier ones.
///
/// For all of it: constructors and factories check their arguments, allocate
/// and throw contact::Error. Const functions do neither, unless they return a
/// container or text; what they cannot compute is NaN, or has a status. Any
/// number of threads may call const functions of one object at a time, and
/// non-const functions of different objects. Tables of the exact laws are built
/// once, on first use.
// clang-format off
#include "libcontact/version.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/pair.hpp"
#include "libcontact/half_angle.hpp"
#include "libcontact/pressure.hpp"
#include "libcontact/friction.hpp"
#include "libcontact/joint.hpp"
#include "libcontact/seat.hpp"
#include "libcontact/play.hpp"
#include "libcontact/finite_pin.hpp"
#include "libcontact/duty.hpp"
#include "libcontact/identify.hpp"
#include "libcontact/load_law.hpp"
#include "libcontact/quantities.hpp"
// clang-format on
