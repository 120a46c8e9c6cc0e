#include "programs/duty/cycle_picture.hpp"

#include <cstddef>

#include "cli/plot.hpp"
#include "libcontact/quantities/tables.hpp"

namespace hinge_duty {

std::string draw_cycle(const contact::JointCycle& cycle,
                       const std::string& title, const std::string& file) {
  cli::PanelPlot plot{
      .title = title, .x = {"time", "s"}, .values = {}, .panels = {}};
  for (const char* key : {"reaction", "friction_moment", "peak_pressure"}) {
    plot.panels.push_back({cli::short_axis_of(*find_quantity(
                               contact::solution_quantities(), key)),
                           {}});
  }
  plot.panels.push_back({{"peak p v", "Pa m/s"}, {}});
  for (const contact::JointCycle::Instant& i : cycle.rows()) {
    const double values[] = {i.solution.reaction.norm(),
                             i.solution.friction_moment.norm(),
                             i.solution.peak_pressure, cycle.pv(i).largest};
    plot.values.push_back(i.time);
    for (std::size_t k = 0; k < plot.panels.size(); ++k) {
      plot.panels[k].y.push_back(values[k]);
    }
  }
  return cli::draw(plot, file);
}

}  // namespace hinge_duty
