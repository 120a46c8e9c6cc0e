#pragma once

#include "libcontact/duty/joint_cycle.hpp"

namespace contact::detail {

/// @throws Error if the half-angle comes above 90 deg in the cycle, see
/// WearMap.
void check_wear(const JointCycle& cycle);

}  // namespace contact::detail
