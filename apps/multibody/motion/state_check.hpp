#pragma once

#include "multibody/motion/equations.hpp"
#include "multibody/motion/motion_state.hpp"

/// Checks of states from outside the motion.
namespace multibody {

/// @throws contact::Error unless hinges can have its modes, and all arrays have
///   the required sizes; otherwise reading would run beyond their ends
void check_layout(const MotionState& state, const Equations& equations);

/// @param state  of such a layout
/// @throws contact::Error unless its numbers are finite, and signs and lengths
///   are possible; the state of a failed motion may have other numbers
void check_numbers(const MotionState& state, const System& system);

}  // namespace multibody
