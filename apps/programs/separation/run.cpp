#include "programs/separation/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <exception>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "cli/choice.hpp"
#include "cli/interrupts.hpp"
#include "cli/joint/key_settings.hpp"
#include "cli/joint/shipped.hpp"
#include "cli/output.hpp"
#include "cli/output_names.hpp"
#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/file_name.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "programs/separation/long_run.hpp"
#include "programs/separation/output/checkpoint.hpp"
#include "programs/separation/output/compare.hpp"
#include "programs/separation/output/events_table.hpp"
#include "programs/separation/output/history_file.hpp"
#include "programs/separation/output/pictures.hpp"
#include "programs/separation/output/summary_report.hpp"
#include "programs/separation/replays.hpp"
#include "programs/separation/stop_rule.hpp"
#include "programs/separation/warnings.hpp"
#include "separation/case/case_reader.hpp"
#include "separation/case/hinge_reader.hpp"
#include "separation/results/saved_state.hpp"
#include "separation/results/summary.hpp"

namespace separation {
namespace {

using contact::detail::must_be;

constexpr std::array<cli::Choice<FrictionChoice>, 3> choices = [] {
  std::array<cli::Choice<FrictionChoice>, 3> all;
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = {friction_choices[i], static_cast<FrictionChoice>(i)};
  }
  return all;
}();

// All files written must have different names.
cli::OutputNames names_of(const Options& o) {
  cli::OutputNames names = names_of(o.output);
  names.add("--history", o.history);
  names.add("--events", o.events);
  if (!o.checkpoint.empty()) {
    // Also read by a resumed run; may replace only a checkpoint.
    cli::Output::check(o.checkpoint);
    for (const std::string& name : checkpoint_files(o.checkpoint)) {
      names.keep("--checkpoint", name);
    }
  }
  for (const std::string& name : o.replays) names.add("--replay", name);
  return names;
}

void keep_pictures(const Options& o, const Case& c, cli::OutputNames names) {
  if (o.output.plot.empty()) return;
  for (const std::string& name :
       picture_names(c, !o.no_clearance, o.output.plot)) {
    names.add("--plot", name);
  }
}

Case case_of(const Options& o) {
  Case c = cli::read_as("a case file", program_name, o.case_file, [&] {
    return read_case(o.case_file, {o.half_angle_law, o.pressure_law},
                     cli::single_settings(o.settings));
  });
  if (o.end_time == 0) return c;
  c.end_time = o.end_time;
  const double most = most_rows * c.output_step;
  if (c.end_time > most) {
    cli::refuse("--end-time", fmt::format("{:.6g}", c.end_time),
                fmt::format("at most {:.6g} s: a history has {:g} rows at most",
                            most, most_rows));
  }
  return c;
}

// Rejects options that do not apply to the case.
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
        fmt::format("at most {:.6g} s, the end of the case", c.end_time)));
  }
  if (!o.output.plot.empty() &&
      picture_names(c, !o.no_clearance, o.output.plot).empty()) {
    cli::refuse_without(
        cli::given("--plot", o.output.plot),
        "a case with hinges or distances: " + o.case_file + " has none");
  }
}

cli::ExitStatus compare(const Case& c, const Options& o) {
  // Checked before the first run.
  for (const Body& body : c.bodies) {
    make_friction(body.hinge, FrictionChoice::traditional);
  }
  Replays replays(c, o);
  Warnings warnings;
  warn_of_joints(c, warnings);
  const cli::Interrupts interrupts;
  const StopRule stop = stop_rule(interrupts, o.step_limit, o.time_limit);
  std::vector<Outcome> outcomes;
  cli::ExitStatus status = cli::all_good;
  for (const auto& [name, choice] : choices) {
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
  if (!replays.write(
          c,
          {{"friction full", &outcomes[1]}, {"friction ideal", &outcomes[0]}},
          warnings)) {
    status = cli::some_bad;
  }
  write_comparison(c, outcomes, o.output);
  return interrupts.status(status);
}

RunOptions run_options(const Options& o) {
  RunOptions run;
  if (!o.friction.empty()) {
    run.friction = cli::choice("--friction", o.friction, choices);
  }
  run.clearance = !o.no_clearance;
  return run;
}

// The tables of a run. They are opened before it, so that a file that cannot be
// made does not cost the results.
struct Tables {
  cli::TableStyle style;
  std::optional<HistoryFile> history = {};
  std::optional<cli::Output> events = {};

  Tables(const Case& c, const Options& o, bool clearance) : style(o.output) {
    style.format = cli::Format::csv;  // --format is the format of the summary
    if (!o.history.empty()) {
      history.emplace(o.history, style, history_columns(c, clearance));
    }
    if (!o.events.empty()) events.emplace(o.events);
  }

  // If a file cannot be written, the others are still written.
  cli::ExitStatus write(const Case& c, const Outcome& outcome) {
    cli::ExitStatus status = cli::all_good;
    const auto write = [&status](const auto& file) {
      try {
        file();
      } catch (const std::exception& error) {
        cli::warn(program_name, error.what());
        status = cli::some_bad;
      }
    };
    if (history) write([&] { history->write(outcome.memory.rows); });
    history.reset();  // and frees its disk space
    if (events) {
      write([&] {
        events->write(events_csv(c, outcome, style));
        events->commit();
      });
    }
    events.reset();
    return status;
  }
};

cli::ExitStatus simulate(const Case& c, const Options& o) {
  RunOptions options = run_options(o);
  Tables tables(c, o, options.clearance);
  Replays replays(c, o);
  cli::Output output(o.output.output);
  Warnings warnings;
  warn_of_joints(c, warnings);

  Checkpoints checkpoints{
      o.checkpoint, o.checkpoint_every, o.resume, {}, identity_of(c, options)};
  if (!o.resume.empty()) {
    checkpoints.from = read_checkpoint(o.resume, checkpoints.identity);
  }
  // Defers signals from here until everything is written.
  const cli::Interrupts interrupts;
  options.stop = stop_rule(interrupts, o.step_limit, o.time_limit);
  const LongRun run = run_long(c, options, std::move(checkpoints));
  const Outcome& outcome = run.outcome;
  bool good = outcome.failure.empty() && run.no_checkpoint.empty();
  warn_of_run(c, outcome, warnings);
  if (!run.no_checkpoint.empty()) warnings.add(run.no_checkpoint);
  good = tables.write(c, outcome) == cli::all_good && good;
  good = replays.write(c, {{"", &outcome}}, warnings) && good;
  if (o.output.format == cli::Format::report) {
    write_report(summary(c, outcome), output, o.output);
  } else {
    output.write(summary(c, outcome).dump(2) + '\n');
  }
  output.commit();
  cli::ExitStatus status = good ? cli::all_good : cli::some_bad;
  if (!o.output.plot.empty()) {
    status = cli::drawn(
        program_name,
        draw_pictures(c, outcome.memory.rows, options.clearance, o.output.plot),
        status);
  }
  return interrupts.status(status);
}

}  // namespace

cli::ExitStatus run(const Options& options) {
  const cli::OutputNames names = names_of(options);
  const Case c = case_of(options);
  check_case(options, c);
  keep_pictures(options, c, names);
  return options.compare ? compare(c, options) : simulate(c, options);
}

}  // namespace separation
