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
#include "libcontact/duty/wear_notes.hpp"
#include "programs/duty/cycle_file.hpp"
#include "programs/duty/cycle_picture.hpp"
#include "programs/duty/map_picture.hpp"
#include "programs/duty/summary.hpp"
#include "programs/duty/tables.hpp"

namespace hinge_duty {
namespace {

using contact::CycleInstant;
using contact::degree;
using contact::JointBody;
using contact::JointCycle;
using contact::WearMap;

constexpr double si_coefficient = 1e-9;  // m^2/N of mm^3/(N m)

struct WearOptions {
  std::optional<double> seat;
  std::optional<double> inner;
  bool wanted;  ///< at all
  int grid;
};

std::optional<double> wear_coefficient(const char* option,
                                       const std::string& text) {
  if (text.empty()) return {};
  return cli::parse_value(option, text, {0, 1e30, "mm^3/(N m)"});
}

WearOptions wear_options(const Options& options) {
  WearOptions wear{wear_coefficient("--wear-seat", options.wear_seat),
                   wear_coefficient("--wear-inner", options.wear_inner), false,
                   2000};
  wear.wanted = wear.seat || wear.inner || !options.map.empty() ||
                !options.map_plot.empty();
  if (options.grid.empty()) return wear;
  if (!wear.wanted) {
    cli::refuse_without(cli::given("--grid", options.grid),
                        "--map, --map-plot, --wear-seat or --wear-inner");
  }
  wear.grid = cli::parse_count("--grid", options.grid, 10, 1'000'000);
  return wear;
}

std::optional<MeasuredWear> measured_wear(const Options& options) {
  if (options.measured_volume.empty()) return {};
  MeasuredWear wear;
  wear.volume = cli::parse_value("--measured-volume", options.measured_volume,
                                 {0, 1e30, "mm^3"});
  wear.cycles = cli::parse_value("--measured-cycles", options.measured_cycles,
                                 {1, 1e15, ""});
  if (!options.measured_error.empty()) {
    wear.error = cli::parse_value("--measured-error", options.measured_error,
                                  {0, 1e30, "mm^3"});
  }
  return wear;
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

contact::JointContact contact_of(const cli::Joint& joint,
                                 const Options& options) {
  return {*joint.geometry,
          joint.pair,
          make_friction(options.friction, joint.friction, options.joint),
          joint.laws[0].law,
          joint.pressures[0].law,
          joint.conditions};
}

void warn_of(std::string_view option, const std::string& note) {
  if (note.empty()) return;
  cli::warn("hinge-duty", fmt::format("{}: {}", option, note));
}

// The joint in the course of --cycles; empty without it.
std::vector<contact::WornState> worn_states(const Options& options,
                                            const WearOptions& wear,
                                            const JointCycle& cycle) {
  if (options.cycles.empty()) {
    if (options.blocks.empty()) return {};
    cli::refuse_without("--blocks", "--cycles");
  }
  const std::string given = cli::given("--cycles", options.cycles);
  if (!wear.seat) cli::refuse_without(given, "--wear-seat");
  const double cycles =
      cli::parse_value("--cycles", options.cycles, {0, 1e15, ""});
  if (wear.inner && *wear.inner > 0) {
    cli::warn("hinge-duty",
              "--cycles: wear of the ball or pin does not change the contact");
  }
  const contact::WearIn worn = contact::wear_in(
      cycle.cycle(), cycle.contact(), *wear.seat * si_coefficient, cycles);
  for (const std::string& note : worn.notes) warn_of("--cycles", note);
  return worn.states;
}

// Of coefficients, but of one that wear_in() has had, and of the unworn joint's
// wear in one cycle.
void warn_of_wear(const Options& options, const WearOptions& wear,
                  const JointCycle& cycle,
                  const std::vector<BodyWear>& bodies) {
  if (wear.seat && options.cycles.empty()) {
    warn_of("--wear-seat",
            contact::wear_coefficient_note(*wear.seat * si_coefficient));
  }
  if (wear.inner) {
    warn_of("--wear-inner",
            contact::wear_coefficient_note(*wear.inner * si_coefficient));
  }
  for (const BodyWear& body : bodies) {
    if (!body.k) continue;
    warn_of("--wear-" + body.surface + ": one cycle",
            contact::wear_depth_note(1e-3 * body.depth(body.deepest.wear),
                                     cycle.contact().geometry()));
  }
}

// Where the wear comes through a wall.
void warn_of_walls(const cli::Joint& joint,
                   const std::vector<contact::WornState>& worn) {
  const auto& walls = joint.conditions.walls;
  if (!walls || worn.empty() || walls->outer().layers.empty()) return;
  const double thickness = walls->outer().layers.front().thickness;
  if (worn.back().penetration < thickness / 2) return;
  cli::warn("hinge-duty",
            fmt::format("--cycles: {:.3g} mm of a layer of {:.3g} mm are gone; "
                        "the contact is that of the whole layer",
                        worn.back().penetration * 1e3, thickness * 1e3));
}

BodyWear wear_of(const JointCycle& cycle, JointBody body,
                 const WearOptions& options) {
  const WearMap map(cycle, body);
  BodyWear wear;
  const bool inner = body == cycle.contact().geometry().inner_body();
  wear.part = body;
  wear.body = body == JointBody::carrier ? "carrier" : "body";
  wear.surface = inner ? "inner" : "seat";
  wear.k = inner ? options.inner : options.seat;
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
  for (const CycleInstant& row : cycle.rows()) {
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
  const WearOptions wear_options = hinge_duty::wear_options(options);
  const std::optional<MeasuredWear> measured = measured_wear(options);
  const cli::Joint joint = make_joint(options.joint);
  const contact::Joint friction(contact_of(joint, options));
  const JointCycle cycle(read_cycle(options, friction.is_pin()), friction);
  std::vector<BodyWear> wear;
  if (wear_options.wanted) {
    for (const JointBody body : {JointBody::carrier, JointBody::body}) {
      wear.push_back(wear_of(cycle, body, wear_options));
    }
  }
  const auto worn = worn_states(options, wear_options, cycle);
  warn_of_wear(options, wear_options, cycle, wear);
  cli::warn_of_validity("hinge-duty", {joint});
  warn_of_cycle(cycle);
  warn_of_walls(joint, worn);

  cli::Output output(options.output.output);
  std::optional<cli::Output> states;
  std::optional<cli::Output> map;
  std::optional<cli::Output> blocks;
  write_summary(cycle, wear, measured, worn, output, options.output);
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
    status = cli::drawn("hinge-duty", draw_cycle(cycle, joint.title(), plot),
                        status);
  }
  if (const std::string& plot = options.map_plot; !plot.empty()) {
    status = cli::drawn("hinge-duty",
                        draw_map(cycle, wear, joint.title(), plot), status);
  }
  return status;
}

}  // namespace hinge_duty
