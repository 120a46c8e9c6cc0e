#include "separation/run.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <vector>

#include "cli/choice.hpp"
#include "cli/output.hpp"
#include "libcontact/error.hpp"
#include "separation/case_reader.hpp"
#include "separation/compare.hpp"
#include "separation/history_file.hpp"
#include "separation/pictures.hpp"
#include "separation/run_case.hpp"
#include "separation/summary.hpp"

namespace separation {
namespace {

constexpr const char* program = "hinge-separation";

constexpr std::array<cli::Choice<FrictionChoice>, 3> friction_choices = {
    {{"full", FrictionChoice::full},
     {"ideal", FrictionChoice::ideal},
     {"traditional", FrictionChoice::traditional}}};

std::string text_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void check(const Options& o) {
  const bool checkpoints = !o.checkpoint.empty() || !o.resume.empty();
  if (o.compare && (checkpoints || !o.history.empty() || !o.events.empty() ||
                    !o.output.plot.empty() || !o.friction.empty())) {
    throw contact::Error(
        "--compare: allowed without --history, --events, --plot, --friction, "
        "--checkpoint, --resume");
  }
  if (!o.compare && o.output.format != cli::Format::csv &&
      o.output.format != cli::Format::json) {
    throw contact::Error(
        "--format: the summary is JSON; tables need --compare");
  }
  if (!o.checkpoint.empty() && o.checkpoint_every == 0 && o.resume.empty()) {
    throw contact::Error("--checkpoint: allowed with --checkpoint-every");
  }
}

// Of the joints, once for each reason.
void print_validity(const Case& c) {
  std::set<std::string> notes;
  for (const Load& load : c.loads) {
    for (const HingeJoint& joint : load.hinge.joints) {
      for (const std::string& note : joint.joint.validity_notes()) {
        notes.insert(fmt::format("joint {}: {}", joint.joint.name, note));
      }
    }
  }
  for (const std::string& note : notes) cli::warn(program, note);
}

void print_overlaps(const Case& c, const Outcome& outcome) {
  for (std::size_t i = 0; i < c.clearance.size(); ++i) {
    const PairRecord& pair = outcome.memory.pairs[i];
    if (pair.overlap_from == History::not_yet) continue;
    cli::warn(program,
              fmt::format("{} and {} overlap from t = {:.6g} s to {:.6g} s",
                          c.body(c.clearance[i].a).name,
                          c.body(c.clearance[i].b).name, pair.overlap_from,
                          pair.overlap_to));
  }
}

cli::ExitStatus compare(const Case& c, const Options& o) {
  std::vector<Outcome> outcomes;
  cli::ExitStatus status = cli::all_good;
  for (const auto& [name, choice] : friction_choices) {
    RunOptions run;
    run.friction = choice;
    run.clearance = false;
    run.progress = true;
    outcomes.push_back(run_case(c, run));
    if (outcomes.back().failure.empty()) continue;
    cli::warn(program,
              fmt::format("friction {}: {}", name, outcomes.back().failure));
    status = cli::some_bad;
  }
  std::swap(outcomes[0], outcomes[1]);  // ideal, full, traditional
  write_comparison(c, outcomes, o.output);
  return status;
}

RunOptions run_options(const Case& c, const Options& o) {
  RunOptions run;
  run.friction = o.friction.empty()
                     ? c.friction
                     : cli::choice("--friction", o.friction, friction_choices);
  run.clearance = !o.no_clearance;
  run.progress = true;
  run.checkpoint = o.checkpoint;
  run.checkpoint_every = o.checkpoint_every;
  run.resume = o.resume;
  run.identity = fmt::format(
      "{}\n{}\n{}\n{}\n{}", static_cast<int>(run.friction), run.clearance,
      o.half_angle_law, o.pressure_law, text_of(o.case_file));
  return run;
}

cli::ExitStatus simulate(const Case& c, const Options& o) {
  const RunOptions options = run_options(c, o);
  // Before the run: files that cannot be made should not cost its result.
  std::optional<HistoryFile> history;
  if (!o.history.empty()) history.emplace(o.history);
  std::optional<cli::Output> events;
  if (!o.events.empty()) events.emplace(o.events);
  cli::Output output(o.output.output);

  const Outcome outcome = run_case(c, options);
  cli::ExitStatus status = cli::all_good;
  if (!outcome.failure.empty()) {
    cli::warn(program, "ended early: " + outcome.failure);
    status = cli::some_bad;
  }
  print_overlaps(c, outcome);
  if (history) history->write(outcome.memory.rows);
  if (events) {
    events->write(events_csv(outcome));
    events->commit();
  }
  output.write(summary(c, outcome).dump(2) + '\n');
  output.commit();
  if (o.output.plot.empty()) return status;
  const std::string problem =
      draw_pictures(c, outcome.memory.rows, o.output.plot);
  if (problem.empty()) return status;
  cli::warn(program, problem);
  return cli::some_bad;
}

}  // namespace

cli::ExitStatus run(const Options& options) {
  check(options);
  const Case c = read_case(options.case_file,
                           {options.half_angle_law, options.pressure_law});
  print_validity(c);
  return options.compare ? compare(c, options) : simulate(c, options);
}

}  // namespace separation
