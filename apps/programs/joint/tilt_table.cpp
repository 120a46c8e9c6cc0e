#include "programs/joint/tilt_table.hpp"

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
  const FinitePin::Motion motion{options.rate.value_or(1),
                                 options.slide.value_or(0)};
  cli::TiltedTable table{.program = "hinge-joint",
                         .load_flag = "--reaction",
                         .load_column = "R_N",
                         .loads = options.reaction,
                         .motion = motion,
                         .columns = cli::pin_columns()};
  if (options.pv) {
    table.columns.push_back(
        {"pv_max_W_per_m2",
         [motion](const FinitePin& pin, const FinitePinSolution& s) {
           return pin.largest_pv(s.contact, motion);
         }});
  }
  return write_tilted(joints, options.tilt, table, options.output);
}

}  // namespace hinge_joint
