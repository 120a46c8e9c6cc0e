#pragma once

/// libcontact, all of it, in physics order: each stage includes only earlier
/// ones.
#include "libcontact/error.hpp"
#include "libcontact/units.hpp"
// material, joint geometry, friction law
// half-angle
// pressure
// friction integrals
#include "libcontact/friction_integrals.hpp"
