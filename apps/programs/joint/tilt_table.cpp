#include "programs/joint/tilt_table.hpp"

#include <functional>
#include <string>
#include <vector>

namespace hinge_joint {

using contact::FinitePin;
using contact::FinitePinSolution;

cli::ExitStatus run_tilted(const Options& options) {
  std::vector<cli::Joint> joints = make_joints(options.joint);
  for (cli::Joint& joint : joints) {
    joint.spec.friction =
        make_friction(options.friction, joint.spec.friction, options.joint);
  }
  const auto columns = cli::pin_columns();
  const FinitePin::Motion motion{options.rate.value_or(1),
                                 options.slide.value_or(0)};
  cli::TiltedTable table{.program = "hinge-joint",
                         .load_flag = "--reaction",
                         .load_column = "R_N",
                         .loads = options.reaction,
                         .motion = motion,
                         .columns = {},
                         .write = {}};
  for (const auto& column : columns) table.columns.push_back(column.name);
  if (options.pv) table.columns.emplace_back("pv_max_W_per_m2");
  table.write = [&](const FinitePin& pin, const FinitePinSolution& s,
                    const std::function<void()>& begin, cli::RowWriter& row) {
    begin();
    for (const auto& column : columns) row.number(column(s) + 0.0);
    if (options.pv) row.number(pin.largest_pv(s.contact, motion));
    row.end();
  };
  return write_tilted(joints, options.tilt, table, options.output);
}

}  // namespace hinge_joint
