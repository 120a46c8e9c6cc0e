#pragma once

#include <string>
#include <vector>

#include "cli/output.hpp"
#include "cli/stream/report.hpp"
#include "cli/table.hpp"
#include "libcontact/duty/wear_in.hpp"
#include "libcontact/quantities/quantity.hpp"
#include "programs/duty/joint_duty.hpp"

/// Writes the CSV files beside the summary, with all columns and rows of all
/// joints.
namespace hinge_duty {

/// Writes the rows of all joints; each begins with the cells that identify its
/// joint.
/// @param write  void(const JointDuty&, RowWriter&, begin): calls begin() first
template <class Write>
void write_rows(const std::vector<JointDuty>& duties,
                const std::vector<std::string>& columns, cli::Output& output,
                const cli::TableStyle& style, const Write& write) {
  cli::write_table(
      style.beside(), cli::joint_columns({duties[0].joint}, {columns}), output,
      [&](cli::RowWriter& to) {
        for (const JointDuty& duty : duties) {
          write(duty, to,
                [&] { write_differences(duty.joint.differences, to); });
        }
      });
}

/// Columns of wear; lengths in mm, volumes in mm^3.
std::vector<contact::Column<contact::WearIn::State>> worn_columns();

/// A row for each block of cycles, and one for the end.
void write_blocks(const std::vector<JointDuty>& duties, cli::Output& output,
                  const cli::TableStyle& style);
/// A row for each row of the cycle's file.
void write_states(const std::vector<JointDuty>& duties, cli::Output& output,
                  const cli::TableStyle& style);
/// A row for each point that wears.
void write_map(const std::vector<JointDuty>& duties, cli::Output& output,
               const cli::TableStyle& style);

}  // namespace hinge_duty
