#include "programs/duty/cycle_picture.hpp"

#include <cstddef>

#include "cli/plot.hpp"

namespace hinge_duty {

std::string draw_cycle(const contact::JointCycle& cycle,
                       const std::string& title, const std::string& file) {
  cli::PanelPlot plot{.title = title,
                      .x_label = "time, s",
                      .x = {},
                      .panels = {{"R", "N", {}},
                                 {"Mₜ", "N m", {}},
                                 {"p", "Pa", {}},
                                 {"p v", "W/m²", {}}}};
  for (const contact::JointCycle::Instant& i : cycle.rows()) {
    const contact::SlidingContact sliding = cycle.sliding(i);
    const double values[] = {
        i.solution.reaction.norm(), i.solution.friction_moment.norm(),
        i.solution.peak_pressure, sliding.largest_pv().value};
    plot.x.push_back(i.time);
    for (std::size_t k = 0; k < plot.panels.size(); ++k) {
      plot.panels[k].y.push_back(values[k]);
    }
  }
  return cli::draw(plot, file);
}

}  // namespace hinge_duty
