#pragma once

#include <vector>

#include "cli/output.hpp"
#include "cli/table.hpp"
#include "libcontact/duty/lies.hpp"
#include "programs/duty/cycle_file.hpp"
#include "programs/duty/joint_duty.hpp"
#include "programs/duty/options.hpp"

/// Pins that end, relieved, tilted or loaded off their middle, on the cycle.
namespace hinge_duty {

/// Throws contact::Error if options, columns of the cycle's file and joints do
/// not fit together.
void check_lies(const Options& options, const CycleFile& file,
                const std::vector<cli::Joint>& joints);

/// How a joint's pin lies by the options or the columns; none: it is level.
contact::Lies lies_of(const Options& options, const CycleFile& file,
                      const cli::Joint& joint);

/// Whether slices answer for a joint: it lies somehow, or has a relief and no
/// other law is asked for.
bool is_sliced(const Options& options, const CycleFile& file,
               const cli::Joint& joint);

/// A row for each of some places along the pin.
void write_along(const std::vector<JointDuty>& duties, cli::Output& output,
                 const cli::TableStyle& style);
/// A row for each place along the pin and angle round each body that wears.
void write_along_map(const std::vector<JointDuty>& duties, cli::Output& output,
                     const cli::TableStyle& style);

}  // namespace hinge_duty
