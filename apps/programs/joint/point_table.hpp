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

/// Writes a row for each line of Options::points, a file of points, and passes
/// its other columns through. A bad line gives ERROR and empty cells, and the
/// other columns if the line could be split.
/// With Options::summary one table of all points instead.
/// Throws contact::Error if the header names no state, or several.
/// @param setup  one joint; columns of the header may require its seat
/// @param begin  called after the header is accepted, before the work
PointResult write_points(Setup& setup, const Options& options,
                         const std::function<void()>& begin);

}  // namespace hinge_joint
