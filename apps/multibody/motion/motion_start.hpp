#pragma once

#include <vector>

#include "multibody/motion/equations.hpp"

namespace multibody {

/// Checked options, ready for the equations.
/// @throws contact::Error if an option does not suit the system
MotionOptions checked_options(const System& system, const MotionStart& start,
                              const MotionOptions& given);

/// State at the start; hinges that can rest there are set to rest first.
/// @throws contact::Error for a start that does not suit the system
std::vector<double> start_state(Equations& equations, const MotionStart& start);

}  // namespace multibody
