#include "programs/angle/pin_table.hpp"

#include "cli/joint/placed_table.hpp"

namespace hinge_angle {

cli::ExitStatus run_placed(const Options& options) {
  cli::PlacedTable table{.program = "hinge-angle",
                         .loads = options.load.load,
                         .tilt = options.tilt};
  for (const char* key :
       {"tilt", "low_half_angle", "high_half_angle", "largest_half_angle",
        "half_angle_place", "low", "high"}) {
    add_lie_column(key, table.columns);
  }
  cli::add_solution_column("peak_pressure", table.columns);
  return write_placed(make_joints(options.joint), table, options.output);
}

}  // namespace hinge_angle
