#include "separation/run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
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
#include "separation/long_run.hpp"
#include "separation/output/compare.hpp"
#include "separation/output/file_name.hpp"
#include "separation/output/history_file.hpp"
#include "separation/output/pictures.hpp"
#include "separation/output/summary.hpp"
#include "separation/record/saved_state.hpp"
#include "separation/replay/page.hpp"
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
  for (const std::string& name : o.replays) cli::Output::check(name);
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
  for (const std::string& name : o.replays) take("--replay", name);
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

// What is said as it is found, and again in a replay.
class Warnings {
 public:
  void add(std::string text) {
    cli::warn(program, text);
    texts_.push_back(std::move(text));
  }
  const std::vector<std::string>& texts() const { return texts_; }

 private:
  std::vector<std::string> texts_;
};

// Of the joints, once for each fit and each reason.
void print_validity(const Case& c, Warnings& warnings) {
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
  for (const std::string& note : notes) warnings.add(note);
}

// Joints whose largest contact leaves the theory or what its materials bear.
void print_contacts(const Case& c, const Outcome& outcome, Warnings& warnings) {
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
  for (const std::string& note : notes) warnings.add(note);
}

void print_overlaps(const Case& c, const Outcome& outcome, Warnings& warnings) {
  for (std::size_t i = 0; i < c.clearance.size(); ++i) {
    const PairRecord& pair = outcome.memory.pairs[i];
    if (pair.not_found > 0) {
      warnings.add(
          fmt::format("the distance of {} and {} was not found {} times",
                      c.rigid_body(c.clearance[i].a).name,
                      c.rigid_body(c.clearance[i].b).name, pair.not_found));
    }
    if (pair.overlap_from == History::not_yet) continue;
    warnings.add(fmt::format("{} and {} overlap from t = {:.6g} s to {:.6g} s",
                             c.rigid_body(c.clearance[i].a).name,
                             c.rigid_body(c.clearance[i].b).name,
                             pair.overlap_from, pair.overlap_to));
  }
}

// Forces that do what was hardly meant.
void print_faults(const Case& c, const Outcome& outcome, Warnings& warnings) {
  for (const std::string& fault : force_faults(c, outcome.memory.forces)) {
    warnings.add(fault);
  }
}

// Events that are in the file for nothing, and forces.
void print_missed(const Case& c, const Outcome& outcome, Warnings& warnings) {
  for (const Missed& missed : missed_events(c, outcome)) {
    warnings.add(fmt::format("event \"{}\" did not come for {}", missed.event,
                             fmt::join(missed.bodies, ", ")));
  }
  for (const std::string& idle : idle_forces(
           c, outcome.history, outcome.memory.forces, outcome.end_time)) {
    warnings.add(idle);
  }
}

// Steps that are too long show in the balance of the energies.
void print_drift(const Case& c, const Outcome& outcome, Warnings& warnings) {
  const Recorder::Memory& memory = outcome.memory;
  constexpr double notable = 1e-5;
  if (c.options.carrier_drive ||
      !(memory.largest_drift > notable * memory.largest_energy)) {
    return;
  }
  warnings.add(fmt::format(
      "the energy strays by {:.2g} J, {:.2g} of its largest "
      "part: shorter steps or smaller tolerances",
      memory.largest_drift, memory.largest_drift / memory.largest_energy));
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

// The files of --replay, which are made before the run.
class Replays {
 public:
  Replays(const Case& c, const Options& o) {
    for (const std::string& name : o.replays) {
      if (is_page(name) && !parts_) {
        parts_.emplace(name);
        if (!o.no_case) case_text_ = text_of_case(c);
      }
      files_.push_back({name, std::make_unique<cli::Output>(name)});
    }
  }

  // What one file has no room for costs the others nothing.
  cli::ExitStatus write(const Case& c, std::vector<ShownRun> runs,
                        Warnings& warnings) {
    cli::ExitStatus status = cli::all_good;
    if (files_.empty()) return status;
    Replay replay{c, std::move(runs), {}, case_text_};
    for (std::string& fault : replay_faults(replay)) {
      warnings.add(std::move(fault));
    }
    replay.warnings = warnings.texts();
    for (auto& [name, file] : files_) {
      try {
        file->write(is_page(name) ? page(replay, name) : replay_glb(replay));
        file->commit();
      } catch (const std::exception& error) {
        cli::warn(program, error.what());
        status = cli::some_bad;
      }
      file.reset();
    }
    return status;
  }

 private:
  // A pipe has been read.
  static std::string text_of_case(const Case& c) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(c.file, ignored)
               ? cli::file_text(c.file)
               : c.content;
  }

  std::string page(const Replay& replay, const std::string& name) const {
    Page page = replay_page(replay, *parts_);
    if (page.every > 1) {
      cli::note(program,
                fmt::format("{} has one of {} rows, to stay below {} MB", name,
                            page.every, most_page / 1'000'000));
    }
    return std::move(page.text);
  }

  struct File {
    std::string name;
    std::unique_ptr<cli::Output> output;
  };
  std::vector<File> files_;
  std::optional<PageParts> parts_;
  std::string case_text_;
};

cli::ExitStatus compare(const Case& c, const Options& o) {
  Replays replays(c, o);
  Warnings warnings;
  print_validity(c, warnings);
  const cli::Interrupts interrupts;
  const StopRule stop = stop_rule(interrupts, o.step_limit, o.time_limit);
  std::vector<Outcome> outcomes;
  cli::ExitStatus status = cli::all_good;
  for (const auto& [name, choice] : friction_choices) {
    RunOptions run;
    run.friction = choice;
    run.clearance = !o.replays.empty();
    run.stop = stop;
    outcomes.push_back(run_long(c, run).outcome);
    if (outcomes.back().failure.empty()) continue;
    warnings.add(fmt::format("friction {}: {}", name, outcomes.back().failure));
    status = cli::some_bad;
  }
  std::swap(outcomes[0], outcomes[1]);  // ideal, full, traditional
  if (replays.write(c, {{"full", &outcomes[1]}, {"ideal", &outcomes[0]}},
                    warnings) != cli::all_good) {
    status = cli::some_bad;
  }
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
  Replays replays(c, o);
  cli::Output output(o.output.output);
  Warnings warnings;
  print_validity(c, warnings);

  // Until everything is written.
  const cli::Interrupts interrupts;
  options.stop = stop_rule(interrupts, o.step_limit, o.time_limit);
  const LongRun run = run_long(
      c, options,
      {o.checkpoint, o.checkpoint_every, o.resume, identity_of(c, options)});
  const Outcome& outcome = run.outcome;
  cli::ExitStatus status = cli::all_good;
  if (!outcome.failure.empty()) {
    warnings.add("ended early: " + outcome.failure);
    status = cli::some_bad;
  } else {
    print_missed(c, outcome, warnings);
  }
  if (!run.no_checkpoint.empty()) {
    warnings.add(run.no_checkpoint);
    status = cli::some_bad;
  }
  print_faults(c, outcome, warnings);
  print_contacts(c, outcome, warnings);
  print_overlaps(c, outcome, warnings);
  print_drift(c, outcome, warnings);
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
  if (replays.write(c, {{"", &outcome}}, warnings) != cli::all_good) {
    status = cli::some_bad;
  }
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
