#pragma once

#include <optional>
#include <vector>

#include "cli/output.hpp"
#include "cli/table.hpp"
#include "libcontact/duty/joint_cycle.hpp"
#include "libcontact/duty/wear_in.hpp"
#include "programs/duty/body_wear.hpp"

namespace hinge_duty {

/// What wore off a body that was weighed.
struct MeasuredWear {
  double volume;                ///< mm^3
  std::optional<double> error;  ///< standard error of it
  double cycles;
};

/// A line for each quantity of the cycle.
/// @param measured  for k, if there is one
/// @param worn      of wear_in(); may be empty
void write_summary(const contact::JointCycle& cycle,
                   const std::vector<BodyWear>& wear,
                   const std::optional<MeasuredWear>& measured,
                   const std::vector<contact::WearIn::State>& worn,
                   cli::Output& output, const cli::TableStyle& style);

}  // namespace hinge_duty
