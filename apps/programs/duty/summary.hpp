#pragma once

#include <optional>

#include "cli/stream/report.hpp"
#include "programs/duty/joint_duty.hpp"

namespace hinge_duty {

/// Wear of a body as weighed.
struct MeasuredWear {
  double volume;                ///< mm^3
  std::optional<double> error;  ///< standard error of the volume
  double cycles;
};

/// Groups of numbers that at least one of the joints has.
struct Have {
  bool rims;  ///< seats that end
  bool ends;  ///< finite-length pins: places along them
};

/// A line for each quantity of the cycle.
/// @param measured  gives k, if not empty
cli::Report summary_of(const JointDuty& duty,
                       const std::optional<MeasuredWear>& measured, Have have);

}  // namespace hinge_duty
