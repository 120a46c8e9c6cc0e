#include "separation/run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "cli/choice.hpp"
#include "cli/file_text.hpp"
#include "cli/interrupts.hpp"
#include "cli/joint/key_settings.hpp"
#include "cli/output.hpp"
#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/pressure/validity.hpp"
#include "separation/case/case_reader.hpp"
#include "separation/case/identity.hpp"
#include "separation/long_run.hpp"
#include "separation/output/compare.hpp"
#include "separation/output/history_file.hpp"
#include "separation/output/pictures.hpp"
#include "separation/output/summary.hpp"
#include "separation/simulation/force_watch.hpp"
#include "separation/stop_rule.hpp"

namespace separation {
namespace {

using contact::detail::must_be;

constexpr const char* program = "hinge-separation";

constexpr std::array<cli::Choice<FrictionChoice>, 3> friction_choices = {
    {{"full", FrictionChoice::full},
     {"ideal", FrictionChoice::ideal},
     {"traditional", FrictionChoice::traditional}}};

// Beside the files that every program has.
void check_outputs(const Options& o) {
  for (const std::string& name : {o.history, o.events, o.checkpoint}) {
    if (!name.empty()) cli::Output::check(name);
  }
}

// Where a name leads, "-" for standard output; "" for what may have several
// names or readers, as /dev/null.
std::string destination(const std::string& name) {
  if (name.empty() || name == "-") return "-";
  std::error_code ignored;
  if (std::filesystem::exists(name, ignored) &&
      !std::filesystem::is_regular_file(name, ignored)) {
    return {};
  }
  const auto path = std::filesystem::weakly_canonical(
      std::filesystem::absolute(name, ignored), ignored);
  return path.empty() ? name : path.string();
}

// Every file that is written has a name of its own.
void check_names(const Options& o, const Case& c) {
  std::map<std::string, std::string> taken;
  const auto take = [&](const std::string& option, const std::string& name) {
    const std::string to = destination(name);
    if (to.empty()) return;
    const auto [place, is_new] = taken.emplace(to, option);
    if (is_new) return;
    cli::refuse(option, to == "-" ? "-" : name,
                "another file than that of " + place->second);
  };
  take("CASE.toml", o.case_file);
  take("--output", o.output.output);
  if (!o.history.empty()) take("--history", o.history);
  if (!o.events.empty()) take("--events", o.events);
  if (!o.checkpoint.empty()) {
    take("--checkpoint", o.checkpoint);
    for (const char* end : {".rows1", ".rows2"}) {
      take("--checkpoint", o.checkpoint + end);
    }
  }
  // To go on with the same checkpoint is as usual.
  if (!o.resume.empty() && destination(o.resume) != destination(o.checkpoint)) {
    take("--resume", o.resume);
  }
  if (o.output.plot.empty()) return;
  for (const std::string& name :
       picture_names(c, !o.no_clearance, o.output.plot)) {
    take("--plot", name);
  }
}

Case case_of(const Options& o) {
  Case c = read_case(o.case_file, {o.half_angle_law, o.pressure_law},
                     cli::single_settings(o.settings));
  if (o.end_time == 0) return c;
  c.end_time = o.end_time;
  const double most = most_rows * c.output_step;
  if (c.end_time > most) {
    cli::refuse(
        "--end-time", fmt::format("{:.6g}", c.end_time),
        fmt::format("up to {:.6g} s: {:g} rows at most", most, most_rows));
  }
  return c;
}

// What the case has nothing for.
void check_case(const Options& o, const Case& c) {
  const auto needs_joints = [&](bool given, const std::string& option) {
    if (!given || c.has_joints()) return;
    cli::refuse_without(option,
                        "a case with joints: " + o.case_file + " has none");
  };
  needs_joints(!o.half_angle_law.empty(),
               cli::given("--law", o.half_angle_law));
  needs_joints(!o.pressure_law.empty(),
               cli::given("--pressure", o.pressure_law));
  needs_joints(o.compare, "--compare");
  if (o.checkpoint_every > c.end_time) {
    throw contact::Error(must_be(
        fmt::format("--checkpoint-every {:.6g}", o.checkpoint_every),
        fmt::format("up to {:.6g} s, the end of the case", c.end_time)));
  }
  if (!o.output.plot.empty() &&
      picture_names(c, !o.no_clearance, o.output.plot).empty()) {
    cli::refuse_without(
        cli::given("--plot", o.output.plot),
        "a case with hinges or distances: " + o.case_file + " has none");
  }
}

// Of the joints, once for each fit and each reason.
void print_validity(const Case& c) {
  std::set<std::string> fits;
  std::set<std::string> notes;
  for (const Body& body : c.bodies) {
    for (const HingeJoint& joint : body.hinge.joints) {
      if (const auto& fit = joint.joint.fit) {
        fits.insert(
            fmt::format("joint {}: {}", joint.joint.name, to_string(*fit)));
      }
      for (const std::string& note : joint.contact.validity_notes()) {
        notes.insert(fmt::format("joint {}: {}", joint.joint.name, note));
      }
    }
  }
  for (const std::string& fit : fits) cli::note(program, fit);
  for (const std::string& note : notes) cli::warn(program, note);
}

// Joints whose largest contact leaves the theory or what its materials bear.
void print_contacts(const Case& c, const Outcome& outcome) {
  std::set<std::string> notes;
  for (std::size_t b = 0; b < c.bodies.size(); ++b) {
    const auto& joints = c.bodies[b].hinge.joints;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const JointPeaks& peaks = outcome.memory.bodies[b].joints[j];
      const contact::JointContact& contact = joints[j].contact;
      for (const std::string& note :
           contact_notes(contact.geometry().kind(), contact.pair(),
                         peaks.half_angle, peaks.pressure)) {
        notes.insert(fmt::format("joint {}: {}", joints[j].joint.name, note));
      }
    }
  }
  for (const std::string& note : notes) cli::warn(program, note);
}

void print_overlaps(const Case& c, const Outcome& outcome) {
  for (std::size_t i = 0; i < c.clearance.size(); ++i) {
    const PairRecord& pair = outcome.memory.pairs[i];
    if (pair.not_found > 0) {
      cli::warn(
          program,
          fmt::format("the distance of {} and {} was not found {} times",
                      c.rigid_body(c.clearance[i].a).name,
                      c.rigid_body(c.clearance[i].b).name, pair.not_found));
    }
    if (pair.overlap_from == History::not_yet) continue;
    cli::warn(program,
              fmt::format("{} and {} overlap from t = {:.6g} s to {:.6g} s",
                          c.rigid_body(c.clearance[i].a).name,
                          c.rigid_body(c.clearance[i].b).name,
                          pair.overlap_from, pair.overlap_to));
  }
}

// Forces that do what was hardly meant.
void print_faults(const Case& c, const Outcome& outcome) {
  for (const std::string& fault : force_faults(c, outcome.memory.forces)) {
    cli::warn(program, fault);
  }
}

// Events that are in the file for nothing, and forces.
void print_missed(const Case& c, const Outcome& outcome) {
  for (const Missed& missed : missed_events(c, outcome)) {
    cli::warn(program,
              fmt::format("event \"{}\" did not come for {}", missed.event,
                          fmt::join(missed.bodies, ", ")));
  }
  for (const std::string& idle : idle_forces(
           c, outcome.history, outcome.memory.forces, outcome.end_time)) {
    cli::warn(program, idle);
  }
}

// Steps that are too long show in the balance of the energies.
void print_drift(const Case& c, const Outcome& outcome) {
  const Recorder::Memory& memory = outcome.memory;
  constexpr double notable = 1e-5;
  if (c.options.carrier_drive ||
      !(memory.largest_drift > notable * memory.largest_energy)) {
    return;
  }
  cli::warn(program,
            fmt::format("the energy strays by {:.2g} J, {:.2g} of its largest "
                        "part: shorter steps or smaller tolerances",
                        memory.largest_drift,
                        memory.largest_drift / memory.largest_energy));
}

// `status`, but for a run that a signal has stopped.
cli::ExitStatus status_of(const cli::Interrupts& interrupts,
                          cli::ExitStatus status) {
  switch (interrupts.signal()) {
    case SIGINT:
      return cli::interrupted;
    case SIGTERM:
      return cli::terminated;
    default:
      return status;
  }
}

cli::ExitStatus compare(const Case& c, const Options& o) {
  print_validity(c);
  const cli::Interrupts interrupts;
  const StopRule stop = stop_rule(interrupts, o.step_limit, o.time_limit);
  std::vector<Outcome> outcomes;
  cli::ExitStatus status = cli::all_good;
  for (const auto& [name, choice] : friction_choices) {
    RunOptions run;
    run.friction = choice;
    run.clearance = false;
    run.stop = stop;
    outcomes.push_back(run_long(c, run).outcome);
    if (outcomes.back().failure.empty()) continue;
    cli::warn(program,
              fmt::format("friction {}: {}", name, outcomes.back().failure));
    status = cli::some_bad;
  }
  std::swap(outcomes[0], outcomes[1]);  // ideal, full, traditional
  write_comparison(c, outcomes, o.output);
  return status_of(interrupts, status);
}

RunOptions run_options(const Case& c, const Options& o) {
  RunOptions run;
  run.friction = o.friction.empty()
                     ? c.friction
                     : cli::choice("--friction", o.friction, friction_choices);
  run.clearance = !o.no_clearance;
  return run;
}

Checkpoints checkpoints_of(const Case& c, const Options& o,
                           const RunOptions& run) {
  Checkpoints result{o.checkpoint, o.checkpoint_every, o.resume};
  result.identity =
      fmt::format("{}\n{}\n", static_cast<int>(run.friction), run.clearance);
  result.identity += identity(c);
  return result;
}

cli::ExitStatus simulate(const Case& c, const Options& o) {
  RunOptions options = run_options(c, o);
  // Before the run: files that cannot be made should not cost its result.
  cli::TableStyle style = o.output;
  style.format = cli::Format::csv;  // what is asked for is of the summary
  std::optional<HistoryFile> history;
  if (!o.history.empty()) {
    history.emplace(o.history, style, history_columns(c, options.clearance));
  }
  std::optional<cli::Output> events;
  if (!o.events.empty()) events.emplace(o.events);
  cli::Output output(o.output.output);
  print_validity(c);

  // Until everything is written.
  const cli::Interrupts interrupts;
  options.stop = stop_rule(interrupts, o.step_limit, o.time_limit);
  const LongRun run = run_long(c, options, checkpoints_of(c, o, options));
  const Outcome& outcome = run.outcome;
  cli::ExitStatus status = cli::all_good;
  if (!outcome.failure.empty()) {
    cli::warn(program, "ended early: " + outcome.failure);
    status = cli::some_bad;
  } else {
    print_missed(c, outcome);
  }
  if (!run.no_checkpoint.empty()) {
    cli::warn(program, run.no_checkpoint);
    status = cli::some_bad;
  }
  print_faults(c, outcome);
  print_contacts(c, outcome);
  print_overlaps(c, outcome);
  print_drift(c, outcome);
  // What one file has no room for costs the others nothing.
  const auto write = [&status](const auto& file) {
    try {
      file();
    } catch (const std::exception& error) {
      cli::warn(program, error.what());
      status = cli::some_bad;
    }
  };
  if (history) write([&] { history->write(outcome.memory.rows); });
  history.reset();  // and the part that it had room for
  if (events) {
    write([&] {
      events->write(events_csv(outcome, style));
      events->commit();
    });
  }
  events.reset();
  output.write(summary(c, outcome).dump(2) + '\n');
  output.commit();
  if (!o.output.plot.empty()) {
    const std::string problem =
        draw_pictures(c, outcome.memory.rows, options.clearance, o.output.plot);
    if (!problem.empty()) {
      cli::warn(program, problem);
      status = cli::some_bad;
    }
  }
  return status_of(interrupts, status);
}

}  // namespace

cli::ExitStatus run(const Options& options) {
  check_outputs(options);
  const Case c = case_of(options);
  check_case(options, c);
  check_names(options, c);
  return options.compare ? compare(c, options) : simulate(c, options);
}

}  // namespace separation
