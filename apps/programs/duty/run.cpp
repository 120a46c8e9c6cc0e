#include "programs/duty/run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/gnuplot.hpp"
#include "cli/output.hpp"
#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/duty/wear_map.hpp"
#include "programs/duty/cycle_file.hpp"
#include "programs/duty/cycle_picture.hpp"
#include "programs/duty/map_picture.hpp"
#include "programs/duty/summary.hpp"
#include "programs/duty/tables.hpp"

namespace hinge_duty {
namespace {

using Instant = contact::JointCycle::Instant;
using contact::degree;
using contact::JointBody;
using contact::JointCycle;
using contact::WearMap;

constexpr double si_coefficient = 1e-9;  // m^2/N of mm^3/(N m)

bool wants_wear(const Options& options) {
  return options.wear_seat || options.wear_inner || !options.map.empty() ||
         !options.map_plot.empty();
}

std::optional<MeasuredWear> measured_wear(const Options& options) {
  if (!options.measured_volume) return {};
  return MeasuredWear{*options.measured_volume, options.measured_error,
                      *options.measured_cycles};
}

// Those beside --output and --plot.
void check_files(const Options& options) {
  cli::OutputNames names = names_of(options.output);
  for (const auto& [option, file] : {std::pair("--map", &options.map),
                                     {"--map-plot", &options.map_plot},
                                     {"--states", &options.states},
                                     {"--blocks", &options.blocks}}) {
    if (*file == "-") cli::refuse(option, *file, "the name of a file");
    names.add(option, *file);
  }
  if (!options.map_plot.empty()) {
    cli::check_picture_name("--map-plot", options.map_plot);
  }
}

void warn_of(std::string_view option, const std::string& note) {
  if (note.empty()) return;
  cli::warn("hinge-duty", fmt::format("{}: {}", option, note));
}

// The joint in the course of --cycles; empty without it.
std::vector<contact::WearIn::State> worn_states(const Options& options,
                                                const JointCycle& cycle) {
  if (!options.cycles) return {};
  if (options.wear_inner && *options.wear_inner > 0) {
    cli::warn("hinge-duty",
              "--cycles: wear of the ball or pin does not change the contact");
  }
  const contact::WearIn worn =
      contact::wear_in(cycle.cycle(), cycle.contact(),
                       *options.wear_seat * si_coefficient, *options.cycles);
  for (const std::string& note : worn.notes) warn_of("--cycles", note);
  return worn.states;
}

// Of coefficients, but of one that wear_in() has had, and of the unworn joint's
// wear in one cycle.
void warn_of_wear(const Options& options, const JointCycle& cycle,
                  const std::vector<BodyWear>& bodies) {
  if (options.wear_seat && !options.cycles) {
    warn_of("--wear-seat", contact::WearMap::coefficient_note(
                               *options.wear_seat * si_coefficient));
  }
  if (options.wear_inner) {
    warn_of("--wear-inner", contact::WearMap::coefficient_note(
                                *options.wear_inner * si_coefficient));
  }
  for (const BodyWear& body : bodies) {
    if (!body.k) continue;
    warn_of("--wear-" + body.surface + ": one cycle",
            contact::WearMap::depth_note(1e-3 * body.depth(body.deepest.wear),
                                         cycle.contact().geometry()));
  }
}

// Where the wear comes through a wall.
void warn_of_walls(const cli::Joint& joint,
                   const std::vector<contact::WearIn::State>& worn) {
  const auto& layers = joint.spec.outer.layers;
  if (worn.empty() || layers.empty()) return;
  const double thickness = layers.front().thickness;
  if (worn.back().penetration < thickness / 2) return;
  cli::warn("hinge-duty",
            fmt::format("--cycles: {:.3g} mm of a layer of {:.3g} mm are gone; "
                        "the contact is that of the whole layer",
                        worn.back().penetration * 1e3, thickness * 1e3));
}

BodyWear wear_of(const JointCycle& cycle, JointBody body,
                 const Options& options) {
  const WearMap map(cycle, body);
  BodyWear wear;
  const bool inner = body == cycle.contact().geometry().inner_body();
  wear.part = body;
  wear.body = body == JointBody::carrier ? "carrier" : "body";
  wear.surface = inner ? "inner" : "seat";
  wear.k = inner ? options.wear_inner : options.wear_seat;
  wear.points = map.grid(options.grid);
  for (const auto& point : wear.points) wear.wear.push_back(map.at(point));
  wear.deepest = map.deepest(wear.points, wear.wear);
  wear.volume_defect = map.volume_defect(wear.wear);
  return wear;
}

void warn_of_cycle(const JointCycle& cycle) {
  const double closure = cycle.cycle().closure() / degree;
  if (closure > 0.1) {
    cli::warn("hinge-duty",
              fmt::format("the rates turn the body by {:.3g} deg more or less "
                          "than whole turns: its wear map and forces in its "
                          "axes are not those of a cycle",
                          closure));
  }
  const contact::JointContact& contact = cycle.contact();
  const contact::ContactLimits limits(contact.half_angle_law(), contact.pair());
  for (const std::string& note : limits.notes(cycle.largest_contact())) {
    cli::warn("hinge-duty", note);
  }
  if (contact.geometry().kind() != contact::JointKind::pin) return;
  double axial = 0;
  for (const Instant& row : cycle.rows()) {
    axial = std::max(axial, std::abs(row.state.reaction.z()));
  }
  if (axial == 0) return;
  cli::warn("hinge-duty",
            fmt::format("a pin takes no force along its axis: R_z of up to "
                        "{:.4g} N is left out",
                        axial));
}

}  // namespace

cli::ExitStatus run(const Options& options) {
  check_files(options);
  const cli::Joint joint = make_joint(options.joint);
  const contact::Joint friction(joint.contact(
      make_friction(options.friction, joint.spec.friction, options.joint)));
  const JointCycle cycle(read_cycle(options, friction.is_pin()), friction);
  std::vector<BodyWear> wear;
  if (wants_wear(options)) {
    for (const JointBody body : {JointBody::carrier, JointBody::body}) {
      wear.push_back(wear_of(cycle, body, options));
    }
  }
  const auto worn = worn_states(options, cycle);
  warn_of_wear(options, cycle, wear);
  cli::warn_of_validity("hinge-duty", {joint});
  warn_of_cycle(cycle);
  warn_of_walls(joint, worn);

  cli::Output output(options.output.output);
  std::optional<cli::Output> states;
  std::optional<cli::Output> map;
  std::optional<cli::Output> blocks;
  write_summary(cycle, wear, measured_wear(options), worn, output,
                options.output);
  if (!options.states.empty()) {
    states.emplace(options.states);
    write_states(cycle, *states, options.output);
  }
  if (!options.map.empty()) {
    map.emplace(options.map);
    write_map(wear, friction.is_pin(), *map, options.output);
  }
  if (!options.blocks.empty()) {
    blocks.emplace(options.blocks);
    write_blocks(worn, *blocks, options.output);
  }
  if (states) states->commit();
  if (blocks) blocks->commit();
  if (map) map->commit();
  output.commit();
  cli::ExitStatus status = cli::all_good;
  if (const std::string& plot = options.output.plot; !plot.empty()) {
    status =
        cli::drawn("hinge-duty", draw_cycle(cycle, joint.title, plot), status);
  }
  if (const std::string& plot = options.map_plot; !plot.empty()) {
    status = cli::drawn("hinge-duty", draw_map(cycle, wear, joint.title, plot),
                        status);
  }
  return status;
}

}  // namespace hinge_duty
