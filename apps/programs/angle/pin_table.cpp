#include "programs/angle/pin_table.hpp"

namespace hinge_angle {

cli::ExitStatus run_tilted(const Options& options) {
  const cli::TiltedTable table{
      .program = "hinge-angle",
      .loads = options.load.load,
      .columns = {"tilt", "low_half_angle", "high_half_angle",
                  "largest_half_angle", "half_angle_place", "low", "high",
                  "peak_pressure"}};
  return write_tilted(make_joints(options.joint), options.tilt, table,
                      options.output);
}

}  // namespace hinge_angle
