#pragma once

#include "libcontact/c/slip.h"
#include "libcontact/joint/joint.hpp"

namespace contact::c {

/// What C was told, to the last bit.
JointSolution solution_of(const contact_solution& solution);
RestSolution rest_of(const contact_rest& rest);

}  // namespace contact::c
