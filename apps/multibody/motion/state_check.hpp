#pragma once

#include "multibody/motion/equations.hpp"
#include "multibody/motion/motion_state.hpp"

/// Checks of states from outside the motion.
namespace multibody {

/// @throws contact::Error unless hinges can have its modes, and there is as
///   much of everything as they ask for: else it would be read beyond its end
void check_layout(const MotionState& state, const Equations& equations);

/// @param state  of such a layout
/// @throws contact::Error unless its numbers are finite, and signs and lengths
///   can be; that of a motion that failed may have others
void check_numbers(const MotionState& state, const System& system);

}  // namespace multibody
