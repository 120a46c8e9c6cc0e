#pragma once

#include "libcontact/duty/wear_in.hpp"

namespace contact::detail {

/// A joint that wears step by step, see wear_in(). Blocks in which the path of
/// PinWear grows by a tenth.
/// @param fresh   without wear
/// @param before  what is gone at the start
/// @param progress  called with the cycles done
WearIn stepped_wear_in(const JointCycle& fresh, const WearCoefficients& k,
                       double cycles, const WornSeat& before,
                       const std::function<void(double)>& progress);

}  // namespace contact::detail
