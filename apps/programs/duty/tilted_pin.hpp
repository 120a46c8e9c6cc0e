#pragma once

#include <vector>

#include "cli/output.hpp"
#include "cli/table.hpp"
#include "libcontact/duty/lies.hpp"
#include "programs/duty/cycle_file.hpp"
#include "programs/duty/joint_duty.hpp"
#include "programs/duty/options.hpp"

/// Finite-length pins with relief, tilt or a load off their middle, over the
/// cycle.
namespace hinge_duty {

/// Throws contact::Error if options, columns of the cycle's file and joints do
/// not fit each other.
void check_lies(const Options& options, const CycleFile& file,
                const std::vector<cli::Joint>& joints);

/// Positions of a joint's pin given by the options or columns; none if level.
contact::Lies lies_of(const Options& options, const CycleFile& file,
                      const cli::Joint& joint);

/// True if a joint is solved by slices: its pin is tilted or loaded off its
/// middle, or has a relief and no other law is asked for.
bool is_sliced(const Options& options, const CycleFile& file,
               const cli::Joint& joint);

/// Writes a row for each of several places along the pin.
void write_along(const std::vector<JointDuty>& duties, cli::Output& output,
                 const cli::TableStyle& style);
/// Writes a row for each place along the pin and each angle round a body that
/// wears.
void write_along_map(const std::vector<JointDuty>& duties, cli::Output& output,
                     const cli::TableStyle& style);

}  // namespace hinge_duty
