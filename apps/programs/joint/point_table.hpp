#pragma once

#include <functional>

#include "programs/joint/points/series.hpp"
#include "programs/joint/setup.hpp"
#include "programs/joint/solution_table.hpp"

namespace hinge_joint {

/// Result of a file of points.
struct PointResult {
  Problems problems;
  /// With --summary or --plot.
  PointSeries series;
};

/// A row for each line of a file of points, which is Options::points; its
/// other columns ride along. The row of a bad line is ERROR, empty cells, and
/// its riding columns if the line could be split.
/// With Options::summary one table of all of them instead.
/// Throws contact::Error if the header names no state, or several.
/// @param setup  one joint, which the header may put in its seat
/// @param begin  called when the header is good, before work
PointResult write_points(Setup& setup, const Options& options,
                         const std::function<void()>& begin);

}  // namespace hinge_joint
