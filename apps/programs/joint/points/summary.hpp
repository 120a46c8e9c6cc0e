#pragma once

#include "programs/joint/points/series.hpp"
#include "programs/joint/setup.hpp"

namespace hinge_joint {

/// Writes peaks with their states and times, means, and the energy dissipated
/// in a duty cycle.
void write_point_summary(const NamedJoint& joint, const PointSeries& series,
                         const cli::OutputOptions& options);

}  // namespace hinge_joint
