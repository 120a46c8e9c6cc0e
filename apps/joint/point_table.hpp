#pragma once

#include <functional>

#include "joint/setup.hpp"
#include "joint/solution_table.hpp"

namespace hinge_joint {

/// A row for each line of a file of points, which is Options::points; its
/// other columns ride along. The row of a bad line is ERROR, empty cells, and
/// its riding columns if the line could be split.
/// Throws contact::Error if the header names no state, or several.
/// @param begin  called when the header and the output are good, before work
Problems write_points(const NamedJoint& joint, const Options& options,
                      const std::function<void()>& begin);

}  // namespace hinge_joint
