#include "programs/angle/pin_table.hpp"

#include <functional>

namespace hinge_angle {

using contact::FinitePin;
using contact::FinitePinSolution;

cli::ExitStatus run_tilted(const Options& options) {
  const auto columns =
      cli::pin_columns({"tilt_x", "tilt_y", "low_half_angle", "high_half_angle",
                        "largest_half_angle", "half_angle_place", "low", "high",
                        "peak_pressure"});
  cli::TiltedTable table{.program = "hinge-angle",
                         .load_flag = "--load",
                         .load_column = "load_N",
                         .loads = options.load.load,
                         .motion = {},
                         .columns = {},
                         .write = {}};
  for (const auto& column : columns) table.columns.push_back(column.name);
  table.write = [&](const FinitePin& /*pin*/, const FinitePinSolution& s,
                    const std::function<void()>& begin, cli::RowWriter& row) {
    begin();
    for (const auto& column : columns) row.number(column(s) + 0.0);
    row.end();
  };
  return write_tilted(make_joints(options.joint), options.tilt, table,
                      options.output);
}

}  // namespace hinge_angle
