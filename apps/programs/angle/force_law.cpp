// hinge-angle --force-law: the force of a joint with play.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "cli/output.hpp"
#include "cli/plot.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/report.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/play/force_law.hpp"
#include "libcontact/play/published_forces.hpp"
#include "libcontact/pressure/validity.hpp"
#include "programs/angle/play.hpp"

namespace hinge_angle {
namespace {

using contact::Dimension;
using contact::ForceLaw;
using contact::ForceState;

// Penetrations of the rows: as given, for given loads, or 400 of the law.
std::vector<double> penetrations(const PlayOptions& options,
                                 const LoadOptions& load,
                                 const cli::Joint& joint, const ForceLaw& law) {
  std::vector<double> all;
  if (!options.penetration.empty()) {
    const cli::Sweep sweep("--penetration", options.penetration,
                           {0, std::numeric_limits<double>::infinity(), "m"},
                           Dimension::length);
    for (std::size_t i = 0; i < sweep.size(); ++i) all.push_back(sweep[i]);
    return all;
  }
  if (!load.load.empty()) {
    const Input input = make_input(load, joint);
    const Loads loads(joint);
    for (std::size_t i = 0; i < input.values.size(); ++i) {
      all.push_back(law.penetration_of_force(
          loads.convert(input.variable, input.values[i], LoadVariable::load)));
    }
    return all;
  }
  constexpr int count = 400;
  const double first = std::log(law.smallest_penetration());
  const double range = std::log(law.largest_penetration()) - first;
  for (int i = 0; i < count - 1; ++i) {
    all.push_back(std::exp(first + range * i / (count - 1)));
  }
  all.push_back(law.largest_penetration());
  return all;
}

// Warns of rows without a value, and of contacts outside the theory.
cli::ExitStatus report(const cli::Joint& joint, const ForceLaw& law,
                       const contact::LargestContact& largest,
                       std::size_t without, std::size_t rows) {
  const contact::ContactLimits limits(*joint.laws[0].law, joint.pair,
                                      joint.spec.geometry);
  for (const std::string& note : limits.notes(largest)) {
    cli::warn("hinge-angle", note);
  }
  if (without == 0) return cli::all_good;
  const double end = law.largest_penetration();
  cli::warn("hinge-angle",
            fmt::format("{} of {} rows are beyond the force law, which ends at "
                        "{:.4g} m, {:.4g} N and {:.4g} deg",
                        without, rows, end, law.force(end),
                        law.half_angle(end) / contact::degree));
  return cli::some_bad;
}

void write_state(double penetration, const ForceState& at, double peak,
                 cli::RowWriter& row) {
  const double exponent = penetration * at.slope / at.force;
  row.number(penetration);
  row.number(at.force);
  row.number(at.slope);
  row.number(at.energy);
  row.number(at.half_angle / contact::degree);
  row.number(at.force_ratio);
  row.number(peak);
  row.number(exponent);
  row.number(at.force / std::pow(penetration, exponent));
  row.end();
}

// Force and stiffness, from 0 to the largest penetration that has values.
std::string draw_law(const cli::Joint& joint, const ForceLaw& law,
                     double largest, const std::string& file) {
  cli::PanelPlot plot{
      .title = joint.title,
      .x = {"penetration", "m"},
      .values = {},
      .panels = {{{"force", "N"}, {}}, {{"stiffness", "N/m"}, {}}}};
  constexpr int points = 400;
  for (int i = 0; i <= points; ++i) {
    const double x = largest * i / points;
    plot.values.push_back(x);
    plot.panels[0].y.push_back(law.force(x));
    plot.panels[1].y.push_back(law.slope(x));
  }
  return cli::draw(plot, file);
}

std::string draw_comparison(const cli::Joint& joint, const ForceLaw& law,
                            const std::vector<double>& deltas,
                            const std::string& file) {
  cli::LinePlot plot;
  plot.title = joint.title;
  plot.x = {"penetration", "m", true};
  plot.y = {"force", "N", true};
  const auto ends = std::ranges::minmax(deltas);
  const double low = std::max(ends.min, law.smallest_penetration());
  cli::Curve exact{"exact", {}, {}, true};
  std::vector<cli::Curve> curves;
  const auto published =
      contact::published_force_laws(joint.spec.geometry, joint.pair);
  for (const auto& other : published) {
    curves.push_back({std::string(other.name), {}, {}});
  }
  constexpr int points = 300;
  for (int i = 0; i <= points; ++i) {
    const double delta = low * std::pow(ends.max / low, double(i) / points);
    const double force = law.force(delta);
    exact.x.push_back(delta);
    exact.y.push_back(force);
    for (std::size_t k = 0; k < published.size(); ++k) {
      const contact::PublishedApproach at = published[k].at(force);
      if (at.outside) continue;
      curves[k].x.push_back(at.penetration);
      curves[k].y.push_back(force);
    }
  }
  plot.curves = {exact};
  for (cli::Curve& curve : curves) {
    if (!curve.x.empty()) plot.curves.push_back(std::move(curve));
  }
  return cli::draw(plot, file);
}

void write_comparison(const cli::Joint& joint, const ForceLaw& law,
                      const std::vector<double>& deltas,
                      const cli::OutputOptions& output) {
  const auto published =
      contact::published_force_laws(joint.spec.geometry, joint.pair);
  std::set<std::string> notes;
  cli::write_table(
      output,
      {"law", "source", "load_N", "theta0_deg", "penetration_m",
       "stiffness_N_per_m", "error_percent", "outside"},
      [&](cli::RowWriter& row) {
        const auto write = [&](std::string_view name, std::string_view source,
                               const ForceState& exact, double delta,
                               double slope, double error, bool outside) {
          row.text(name);
          row.text(source);
          row.number(exact.force);
          row.number(exact.half_angle / contact::degree);
          row.number(delta);
          row.number(slope);
          row.number(error);
          if (outside) {
            row.text("yes");
          } else {
            row.empty();
          }
          row.end();
        };
        for (const double delta : deltas) {
          const ForceState at = law.at(delta);
          write("exact", "linear elasticity", at, delta, at.slope, 0, false);
          for (const auto& other : published) {
            const contact::PublishedApproach is = other.at(at.force);
            write(other.name, other.source, at, is.penetration, is.slope,
                  100 * (is.penetration / delta - 1), is.outside);
            if (!is.outside) continue;
            notes.insert(fmt::format(
                "law {}: outside its range at some loads, where its force "
                "decreases or it was not fitted{}{}",
                other.name, other.note.empty() ? "" : ": ", other.note));
          }
        }
      });
  for (const std::string& note : notes) cli::warn("hinge-angle", note);
  if (!joint.spec.outer.layers.empty()) {
    cli::note("hinge-angle", "published laws ignore walls");
  }
}

}  // namespace

cli::ExitStatus run_force_law(const PlayOptions& options,
                              const cli::JointOptions& joint_options,
                              const LoadOptions& load, bool compare,
                              const cli::OutputOptions& output) {
  const cli::Joint joint = sized_joint(joint_options, "--force-law");
  const ForceLaw law(joint.spec);
  const std::vector<double> deltas = penetrations(options, load, joint, law);
  const double largest = std::ranges::max(deltas);
  if (!output.plot.empty() && deltas.size() == 1) {
    cli::refuse_without("--plot", "a range of loads or penetrations");
  }
  cli::warn_of_validity("hinge-angle", {joint});
  const contact::PressureLaw& pressure = *joint.pressures[0].law;
  contact::LargestContact contacts;
  std::size_t without = 0;
  const auto peak_at = [&](const ForceState& at) {
    if (at.force == 0) return 0.0;
    const contact::JointGeometry& g = joint.spec.geometry;
    return pressure.peak(at.half_angle) *
           g.pressure_unit(g.load_from_force(at.force));
  };
  for (const double delta : deltas) {
    const ForceState at = law.at(delta);
    if (std::isnan(at.force)) ++without;
    contacts.add(at.half_angle, peak_at(at));
  }
  if (compare) {
    write_comparison(joint, law, deltas, output);
  } else {
    cli::write_table(output,
                     {"penetration_m", "force_N", "stiffness_N_per_m",
                      "energy_J", "theta0_deg", "force_ratio", "p_peak_Pa",
                      "exponent", "coefficient_N_per_m_to_exponent"},
                     [&](cli::RowWriter& row) {
                       for (const double delta : deltas) {
                         const ForceState at = law.at(delta);
                         write_state(delta, at, peak_at(at), row);
                       }
                     });
  }
  const cli::ExitStatus status =
      report(joint, law, contacts, without, deltas.size());
  if (output.plot.empty()) return status;
  return cli::drawn("hinge-angle",
                    compare ? draw_comparison(joint, law, deltas, output.plot)
                            : draw_law(joint, law, largest, output.plot),
                    status);
}

}  // namespace hinge_angle
