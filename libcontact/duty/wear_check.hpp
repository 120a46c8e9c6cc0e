#pragma once

#include "libcontact/duty/joint_cycle.hpp"

namespace contact::detail {

/// @throws Error if the half-angle comes above 90 deg in the cycle, see
/// WearMap.
void check_wear(const JointCycle& cycle);

/// @param depth  of the wear, m
/// @throws Error if it is above the radius, or no number.
void check_depth(double depth, double cycles, const JointGeometry& geometry);

}  // namespace contact::detail
