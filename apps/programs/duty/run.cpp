#include "programs/duty/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/gnuplot.hpp"
#include "cli/joint/joint_reports.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/file_text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/duty/wear_map.hpp"
#include "libcontact/files/worn_seat_file.hpp"
#include "programs/duty/cycle_file.hpp"
#include "programs/duty/cycle_picture.hpp"
#include "programs/duty/map_picture.hpp"
#include "programs/duty/summary.hpp"
#include "programs/duty/tables.hpp"
#include "programs/duty/tilted_pin.hpp"

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

void require_file(std::string_view option, const std::string& name) {
  if (name == "-") cli::refuse(option, name, "the name of a file");
}

// Checks the files beside --output and --plot.
void check_files(const Options& options) {
  cli::OutputNames names = names_of(options.output);
  for (const auto& [option, file] : {std::pair("--map", &options.map),
                                     {"--map-plot", &options.map_plot},
                                     {"--states", &options.states},
                                     {"--blocks", &options.blocks},
                                     {"--worn-out", &options.worn_out},
                                     {"--along", &options.along},
                                     {"--along-map", &options.along_map}}) {
    require_file(option, *file);
    names.add(option, *file);
  }
  if (!options.seat_table.empty()) {
    // The file is also read if it exists.
    require_file("--seat-table", options.seat_table);
    cli::Output::check(options.seat_table);
    names.keep("--seat-table", options.seat_table);
  }
  if (!options.worn_out.empty() && options.worn == options.worn_out) {
    cli::refuse("--worn-out", options.worn_out, "another file than --worn");
  }
  if (!options.map_plot.empty()) {
    cli::check_picture_name("--map-plot", options.map_plot);
  }
}

void warn_of(std::string_view option, const std::string& note) {
  if (note.empty()) return;
  cli::warn("hinge-duty", fmt::format("{}: {}", option, note));
}
void warn_of(const cli::Joint& joint, const std::string& note) {
  if (note.empty()) return;
  cli::warn("hinge-duty", said_of(joint, note));
}

contact::JointContact endless_contact(const Options& options,
                                      const JointDuty& duty) {
  const contact::JointContact& contact = duty.cycle.contact();
  if (duty.cycle.joint().is_endless() && !duty.ends) return contact;
  return asked_spec(duty.joint, contact.friction(), options.joint)
      .without_seat()
      .contact();
}

// Computes the wear of the joint over --cycles; nothing without this option.
void wear_in(const Options& options, JointDuty& duty) {
  if (!options.cycles) return;
  const JointCycle& cycle = duty.cycle;
  if (cycle.is_at_rims()) {
    throw contact::Error(said_of(
        duty.joint,
        contact::detail::needs("--cycles with contacts at the rims of a [seat]",
                               "--without-seat")));
  }
  contact::WornSeat before;
  if (!options.worn.empty()) {
    before = contact::read_worn_seat(options.worn, cycle.contact().geometry());
  }
  const bool has_map = !options.worn.empty() || !options.worn_out.empty();
  contact::WearIn worn = made_of(duty.joint, [&] {
    cli::ShareDone done("the cycles");  // erased before the warnings
    return contact::wear_in(cycle.cycle(), endless_contact(options, duty),
                            {options.wear_seat.value_or(0) * si_coefficient,
                             options.wear_inner.value_or(0) * si_coefficient},
                            *options.cycles, has_map ? &before : nullptr,
                            [&](double cycles) {
                              if (cycles > 0)
                                done.come_to(cycles / *options.cycles);
                            });
  });
  if (duty.ends) {
    worn.notes.emplace_back("the pin is taken level and without its ends");
  }
  for (const std::string& note : worn.notes) {
    warn_of(duty.joint, "--cycles: " + note);
  }
  duty.worn = std::move(worn.states);
  duty.worn_seat = std::move(worn.worn);
}

// Warns of other coefficients than those that wear_in() checks.
void warn_of_coefficients(const Options& options) {
  if (options.wear_seat && !options.cycles) {
    warn_of("--wear-seat", contact::WearMap::coefficient_note(
                               *options.wear_seat * si_coefficient));
  }
  if (options.wear_inner && !options.cycles) {
    warn_of("--wear-inner", contact::WearMap::coefficient_note(
                                *options.wear_inner * si_coefficient));
  }
}

// Warns of the unworn joint's wear in one cycle.
void warn_of_wear(const JointDuty& duty) {
  for (const BodyWear& body : duty.wear) {
    if (!body.k) continue;
    const std::string note = contact::WearMap::depth_note(
        1e-3 * body.depth(body.deepest.wear), duty.cycle.contact().geometry());
    if (note.empty()) continue;
    warn_of(duty.joint,
            fmt::format("--wear-{}: one cycle: {}", body.surface, note));
  }
}

// Warns if wear penetrates a wall.
void warn_of_walls(const JointDuty& duty) {
  const auto& layers = duty.joint.spec.outer.layers;
  if (duty.worn.empty() || layers.empty()) return;
  const double thickness = layers.front().thickness;
  const double penetration = duty.worn.back().penetration;
  if (penetration < thickness / 2) return;
  warn_of(duty.joint,
          fmt::format("--cycles: {:.3g} mm of a {:.3g} mm layer are worn off; "
                      "the contact is computed with the full thickness",
                      penetration * 1e3, thickness * 1e3));
}

BodyWear wear_of(const JointDuty& duty, JointBody body,
                 const Options& options) {
  const JointCycle& cycle = duty.cycle;
  const WearMap map(cycle, body);
  const bool inner = body == cycle.contact().geometry().inner_body();
  const auto points = map.grid(options.grid);
  const std::vector<WearMap::Wear> worn = map.at(points);
  return {.body = body == JointBody::carrier ? "carrier" : "body",
          .surface = inner ? "inner" : "seat",
          .k = duty.wear_coefficient(body),
          .map = map,
          .points = points,
          .wear = worn,
          .deepest = map.deepest(points, worn),
          .volume_defect = map.volume_defect(worn)};
}

// The wear of both bodies of all joints; along finite-length pins from
// --along-map.
void wear(const Options& options, std::vector<JointDuty>& duties) {
  if (!wants_wear(options) || have_ends(duties)) return;
  for (JointDuty& duty : duties) {
    for (const JointBody body : {JointBody::carrier, JointBody::body}) {
      duty.wear.push_back(wear_of(duty, body, options));
    }
  }
}

// Warns of properties of the cycle that all joints share.
void warn_of_cycle(const JointCycle& cycle) {
  const bool is_pin =
      cycle.contact().geometry().kind() == contact::JointKind::pin;
  for (const std::string& note : cycle.cycle().notes(is_pin)) {
    cli::warn("hinge-duty", note);
  }
}

void warn_of_contact(const JointDuty& duty) {
  const contact::JointContact& contact = duty.cycle.contact();
  for (const std::string& note : duty.cycle.notes()) {
    warn_of(duty.joint, note);
  }
  const bool closed =
      std::ranges::any_of(duty.cycle.rows(), [](const Instant& row) {
        return row.solution.contact_state == contact::ContactState::closed;
      });
  if (!closed) return;
  warn_of(duty.joint,
          fmt::format("the contact is closed all round up to {:.4g} N: wear "
                      "debris cannot leave it and lubricant cannot enter",
                      contact.lift_off_force()));
}

void check_one_joint(const Options& options, std::size_t joints) {
  if (joints == 1) return;
  for (const auto& [option, file] : {std::pair("--plot", &options.output.plot),
                                     {"--map-plot", &options.map_plot},
                                     {"--worn", &options.worn},
                                     {"--worn-out", &options.worn_out}}) {
    if (!file->empty()) cli::refuse_without(option, "one joint");
  }
}

bool is_in_seat(const Options& options, const cli::Joint& joint) {
  return !options.without_seat && joint.spec.geometry.seat();
}

void check_seats(const Options& options,
                 const std::vector<cli::Joint>& joints) {
  const bool any = std::ranges::any_of(joints, [](const cli::Joint& joint) {
    return joint.spec.geometry.seat().has_value();
  });
  const bool has_table = !options.seat_table.empty();
  if (!any && (options.without_seat || has_table)) {
    cli::refuse_without(has_table ? "--seat-table" : "--without-seat",
                        "a joint with a [seat]");
  }
  if (has_table && joints.size() != 1) {
    cli::refuse_without("--seat-table", "one joint");
  }
}

// The joint by its own model, with the exact laws; it uses a kept table
// if there is one.
contact::Joint joint_of(const Options& options, const CycleFile& cycle,
                        cli::Joint& joint, contact::JointSpec& spec,
                        contact::SharedLaws& laws) {
  const contact::FrictionModel& friction = *joint.spec.friction;
  const bool is_by_slices = is_sliced(options, cycle, joint);
  spec = asked_spec(joint, friction, options.joint);
  if (!is_by_slices && !is_in_seat(options, joint)) {
    return contact::Joint(joint.contact(friction));
  }
  if (is_by_slices) {
    spec.half_angle_law = spec.pressure_law = "exact";
    spec.half_angle_options = {};
    joint.spec = joint.spec.endless();  // so that no end is noted
  }
  const contact::Joint made(spec, laws);
  joint.laws = {{spec.half_angle_law, laws.half_angle(spec)}};
  const std::string& file = options.seat_table;
  if (file.empty() || !std::filesystem::exists(file)) return made;
  try {
    return made.tabulated(contact::detail::file_text(file));
  } catch (const contact::Error& error) {
    throw contact::Error(
        fmt::format("--seat-table {}: {}", file, error.what()));
  }
}

JointCycle cycle_of(const contact::DutyCycle& cycle,
                    const contact::Joint& joint, const contact::Lies& lies) {
  cli::ShareDone done("a table of contacts");
  return {cycle, joint, lies, [&](double share) { done.come_to(share); }};
}

void keep_table(const Options& options, const contact::Joint& joint) {
  const std::string& file = options.seat_table;
  if (file.empty() || std::filesystem::exists(file)) return;
  const std::string table = joint.table();
  if (table.empty()) return;
  cli::Output output(file);
  output.write(table);
  output.commit();
}

void check_maps(const Options& options, const std::vector<JointDuty>& duties) {
  if (!have_ends(duties)) return;
  for (const auto& [option, file] :
       {std::pair("--map", &options.map), {"--map-plot", &options.map_plot}}) {
    if (file->empty()) continue;
    throw contact::Error(contact::detail::needs(
        fmt::format("{} of a pin that ends", option), "--along-map"));
  }
}

// Computes all joints over the cycle.
std::vector<JointDuty> run_joints(const Options& options,
                                  std::vector<cli::Joint>& joints) {
  for (cli::Joint& joint : joints) {
    joint.spec.friction = made_of(joint, [&] {
      return make_friction(options.friction, joint.spec.friction,
                           options.joint);
    });
  }
  const CycleFile file = read_cycle(options, joints[0].is_pin());
  check_lies(options, file, joints);
  contact::SharedLaws laws;
  std::vector<JointDuty> duties;
  for (cli::Joint& joint : joints) {
    const bool ends = is_sliced(options, file, joint);
    contact::JointSpec spec = joint.spec;
    JointCycle cycle = made_of(joint, [&] {
      const contact::Lies lies = lies_of(options, file, joint);
      return cycle_of(file.cycle, joint_of(options, file, joint, spec, laws),
                      lies);
    });
    duties.push_back({joint, std::move(spec), std::move(cycle), ends});
    duties.back().wear_seat = options.wear_seat;
    duties.back().wear_inner = options.wear_inner;
  }
  check_maps(options, duties);
  keep_table(options, duties[0].cycle.joint());
  return duties;
}

// Warns of limits that matter before the numbers are used.
void warn(const Options& options, const std::vector<cli::Joint>& joints,
          const std::vector<JointDuty>& duties) {
  warn_of_coefficients(options);
  for (const JointDuty& duty : duties) warn_of_wear(duty);
  cli::warn_of_validity("hinge-duty", joints);
  warn_of_cycle(duties[0].cycle);
  for (const JointDuty& duty : duties) {
    warn_of_contact(duty);
    warn_of_walls(duty);
  }
}

void write_tables(const Options& options, const std::vector<cli::Joint>& joints,
                  const std::vector<JointDuty>& duties) {
  std::vector<cli::Report> reports;
  for (const JointDuty& duty : duties) {
    reports.push_back(summary_of(duty, measured_wear(options),
                                 {have_seat(duties), have_ends(duties)}));
  }
  cli::Output output(options.output.output);
  write_reports(joints, reports, output, options.output);
  std::deque<cli::Output> beside;  // complete before the first appears
  for (const auto& [file, write] : {std::pair(&options.states, &write_states),
                                    {&options.blocks, &write_blocks},
                                    {&options.along, &write_along},
                                    {&options.along_map, &write_along_map},
                                    {&options.map, &write_map}}) {
    if (file->empty()) continue;
    write(duties, beside.emplace_back(*file), options.output);
  }
  if (!options.worn_out.empty()) {
    beside.emplace_back(options.worn_out)
        .write(contact::worn_seat_text(duties[0].worn_seat,
                                       duties[0].cycle.contact().geometry()));
  }
  for (cli::Output& table : beside) table.commit();
  output.commit();
}

}  // namespace

cli::ExitStatus run(const Options& options) {
  check_files(options);
  std::vector<cli::Joint> joints = make_joints(options.joint);
  check_one_kind(joints);
  check_seats(options, joints);
  check_one_joint(options, joints.size());
  std::vector<JointDuty> duties = run_joints(options, joints);
  for (JointDuty& duty : duties) wear_in(options, duty);
  wear(options, duties);
  warn(options, joints, duties);
  write_tables(options, joints, duties);
  const JointDuty& duty = duties[0];
  cli::ExitStatus status = cli::all_good;
  if (const std::string& plot = options.output.plot; !plot.empty()) {
    status = cli::drawn("hinge-duty",
                        draw_cycle(duty.cycle, duty.joint.title, plot), status);
  }
  if (const std::string& plot = options.map_plot; !plot.empty()) {
    status = cli::drawn(
        "hinge-duty",
        draw_map(duty.joint.is_pin(), duty.wear, duty.joint.title, plot),
        status);
  }
  return status;
}

}  // namespace hinge_duty
