#pragma once

#include <vector>

#include "cli/output.hpp"
#include "cli/stream/report.hpp"
#include "cli/table.hpp"
#include "programs/duty/cycle_file.hpp"
#include "programs/duty/joint_duty.hpp"
#include "programs/duty/options.hpp"

/// Pins that end, tilted or loaded off their middle, on the cycle.
namespace hinge_duty {

/// Adds them to the joints, if options or columns of the cycle's file ask for
/// it. Throws contact::Error if they do not fit together.
void add_pins(const Options& options, const CycleFile& file,
              std::vector<JointDuty>& duties);

/// The largest values with their times and places, and the sums.
void add_pin(const contact::PinCycle& pin, cli::Report& to);

/// A row for each row of the cycle's file.
void write_pin_states(const std::vector<JointDuty>& duties, cli::Output& output,
                      const cli::TableStyle& style);
/// A row for each of some places along the pin.
void write_along(const std::vector<JointDuty>& duties, cli::Output& output,
                 const cli::TableStyle& style);
/// A row for each place along the pin and angle round each body that wears.
void write_along_map(const std::vector<JointDuty>& duties, cli::Output& output,
                     const cli::TableStyle& style);

}  // namespace hinge_duty
