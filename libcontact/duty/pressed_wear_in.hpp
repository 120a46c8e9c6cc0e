#pragma once

#include "libcontact/duty/wear_in.hpp"

namespace contact::detail {

/// States of a pin that begins without clearance or with interference, see
/// wear_in(): blocks in which the path of PinWear grows by a tenth.
/// @param fresh  before wear
std::vector<WearIn::State> pressed_wear_in(const JointCycle& fresh,
                                           const WearCoefficients& k,
                                           double cycles);

}  // namespace contact::detail
