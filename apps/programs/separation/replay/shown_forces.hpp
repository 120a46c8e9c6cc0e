#pragma once

#include <vector>

#include "programs/separation/replay/scene.hpp"
#include "separation/results/run.hpp"

namespace separation {

/// Six numbers for each row of a take and each force of its case: the force on
/// its body and its moment about the point of application (ForceLaw::where),
/// inertial axes, N and N m. NaN while the force does not act.
std::vector<float> shown_forces(const Take& take, const History& history);

}  // namespace separation
