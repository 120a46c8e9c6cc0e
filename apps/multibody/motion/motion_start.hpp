#pragma once

#include <vector>

#include "multibody/motion/equations.hpp"

namespace multibody {

/// Checked options, ready for the equations.
/// @throws contact::Error if it does not fit
MotionOptions checked_options(const System& system, const MotionStart& start,
                              const MotionOptions& given);

/// The state at the start; hinges that can rest there do, for now.
/// @throws contact::Error for a start that does not fit the system
std::vector<double> start_state(Equations& equations, const MotionStart& start);

}  // namespace multibody
