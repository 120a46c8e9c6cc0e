#pragma once

#include <vector>

#include "cli/output.hpp"
#include "cli/table.hpp"
#include "libcontact/duty/wear_in.hpp"
#include "libcontact/quantities/quantity.hpp"
#include "programs/duty/joint_duty.hpp"

/// The CSV files beside the summary, with all columns and rows of all joints.
namespace hinge_duty {

/// Columns of wear, lengths and volumes in mm and mm^3.
std::vector<contact::Column<contact::WearIn::State>> worn_columns();

/// A row for each block of cycles, and one for the end.
void write_blocks(const std::vector<JointDuty>& duties, cli::Output& output,
                  const cli::TableStyle& style);
/// A row for each row of the cycle's file.
void write_states(const std::vector<JointDuty>& duties, cli::Output& output,
                  const cli::TableStyle& style);
/// The same of the contact that is confined to its seat.
void write_in_seat(const std::vector<JointDuty>& duties, cli::Output& output,
                   const cli::TableStyle& style);
/// A row for each point that wears.
void write_map(const std::vector<JointDuty>& duties, cli::Output& output,
               const cli::TableStyle& style);

}  // namespace hinge_duty
