#pragma once

#include <optional>

#include "cli/stream/report.hpp"
#include "programs/duty/joint_duty.hpp"

namespace hinge_duty {

/// Wear of a body by weighing.
struct MeasuredWear {
  double volume;                ///< mm^3
  std::optional<double> error;  ///< standard error of it
  double cycles;
};

/// Groups of numbers that some of the joints have.
struct Have {
  bool rims;  ///< seats that end
  bool ends;  ///< pins that end: places along them
};

/// A line for each quantity of the cycle.
/// @param measured  for k, if there is one
cli::Report summary_of(const JointDuty& duty,
                       const std::optional<MeasuredWear>& measured, Have have);

}  // namespace hinge_duty
