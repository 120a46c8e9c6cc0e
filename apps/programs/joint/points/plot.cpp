#include "programs/joint/points/plot.hpp"

#include <fmt/format.h>

#include <limits>

#include "cli/plot.hpp"
#include "libcontact/quantities/tables.hpp"

namespace hinge_joint {
namespace {

// Indices in point_columns().
constexpr std::size_t reaction = 0;
constexpr std::size_t normal_force = 1;
constexpr std::size_t moment_column = 2;
constexpr std::size_t peak_pressure = 4;

}  // namespace

std::string draw_points(const Setup& setup, const PointSeries& series,
                        const std::string& file) {
  if (series.rows().empty()) {
    return fmt::format("no picture {}: no state has a solution", file);
  }
  const NamedJoint& joint = setup.joints[0];
  const bool is_contact = series.question() == Question::contact;
  const std::size_t shown[] = {
      moment_column, is_contact ? normal_force : reaction, peak_pressure};
  cli::PanelPlot plot;
  plot.title = fmt::format("{}, law {}, pressure {}", setup.given[0].title,
                           joint.law, joint.pressure);
  plot.x = series.has_time() ? cli::Axis{"time", "s"} : cli::Axis{"state"};
  for (const char* key :
       {"friction_moment", is_contact ? "normal_force" : "reaction",
        "peak_pressure"}) {
    plot.panels.push_back({cli::short_axis_of(*contact::find_quantity(
                               contact::solution_quantities(), key)),
                           {}});
  }
  std::size_t last = 0;
  const auto add = [&](double x, const PointRow* row) {
    plot.values.push_back(x);
    for (std::size_t i = 0; i < plot.panels.size(); ++i) {
      plot.panels[i].y.push_back(row == nullptr
                                     ? std::numeric_limits<double>::quiet_NaN()
                                     : row->values[shown[i]]);
    }
  };
  for (const PointRow& row : series.rows()) {
    const double x =
        series.has_time() ? row.time : static_cast<double>(row.state);
    if (row.state > last + 1) add(x, nullptr);  // a gap
    add(x, &row);
    last = row.state;
  }
  return cli::draw(plot, file);
}

}  // namespace hinge_joint
