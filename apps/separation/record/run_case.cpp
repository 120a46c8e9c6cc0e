#include "separation/record/run_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "cli/progress.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "separation/record/checkpoint.hpp"
#include "separation/simulation/pace.hpp"

namespace separation {
namespace {

// Times at which a run is looked at, 0 to count.
class OutputTimes {
 public:
  OutputTimes(const Case& c, bool only_events)
      : end_(c.end_time),
        step_(only_events ? c.end_time : c.output_step),
        // A last step of a rounding error's length is none.
        count_(std::max(
            1L, static_cast<long>(std::ceil(c.end_time / step_ - rounding)))) {}
  long count() const { return count_; }
  long after(double time) const {
    return static_cast<long>(std::floor(time / step_ + rounding)) + 1;
  }
  double operator[](long i) const {
    return i >= count_ ? end_ : static_cast<double>(i) * step_;
  }

 private:
  static constexpr double rounding = 1e-9;  // of a step
  double end_;
  double step_;
  long count_;
};

// A motion with what is remembered of it.
struct Run {
  std::unique_ptr<Simulation> simulation;
  Recorder recorder;
  bool between_looks;
  StopRule stop;
  std::optional<cli::Progress> progress = {};
  multibody::MotionCounts counts = {};  // of simulations that are gone
  Pace pace = {};
  std::string failure = {};
  std::string way_on = {};  // for who stops it

  void start(const Case& c, FrictionChoice friction) {
    simulation = std::make_unique<Simulation>(c, friction);
    simulation->halt_when([this] {
      pace.note(*simulation);
      return stop && !(failure = stop(all_counts().steps)).empty();
    });
    if (!between_looks && !progress) return;
    simulation->watch_steps(
        [this, end = c.end_time](const multibody::MotionSample& sample) {
          if (between_looks) recorder.look_between(*simulation);
          if (progress && progress->is_due()) show(sample.time(), end);
        });
  }
  void show(double time, double end) {
    std::string text = fmt::format("{:.6g} s of {:.6g} s, {} steps, ", time,
                                   end, all_counts().steps);
    if (progress->is_terminal()) {
      text +=
          fmt::format("the last {:.2g} s", simulation->motion().last_step());
    } else {
      text = "hinge-separation: " + text + pace.text(*simulation);
    }
    progress->say(text);
  }

  // Moves on to `time` with all events on the way; false: `failure` says why.
  bool move_on(double time) {
    for (;;) {
      switch (simulation->advance_to(time)) {
        case Simulation::Stop::time:
          return true;
        case Simulation::Stop::failed:
          failure = simulation->message();
          return false;
        case Simulation::Stop::halted:
          failure =
              fmt::format("t = {:.6g} s: stopped by {} after {} steps: {}{}",
                          simulation->time(), failure, all_counts().steps,
                          pace.text(*simulation), way_on);
          return false;
        case Simulation::Stop::event:
          recorder.look(*simulation);
          recorder.before(*simulation, simulation->happenings());
          if (!simulation->apply()) {
            failure = simulation->message();
            return false;
          }
          recorder.look(*simulation);
      }
    }
  }

  multibody::MotionCounts all_counts() const {
    const multibody::MotionCounts now = simulation->motion().counts();
    return {counts.evaluations + now.evaluations, counts.steps + now.steps,
            counts.outer_iterations + now.outer_iterations};
  }
  // From now on as a new simulation that goes on from there: what a run does
  // after a checkpoint does not depend on whether it was interrupted.
  void go_on_from(const SimulationState& state, const Case& c,
                  FrictionChoice friction) {
    if (simulation) counts = all_counts();
    start(c, friction);
    simulation->restore(state);
    recorder.go_on_with(*simulation);
  }
};

// The time of the first checkpoint after `time`: of the time alone, so that it
// is the same in a run that was interrupted.
double checkpoint_after(double time, double every) {
  // A rounding error before a checkpoint's time is that time.
  return every * (std::floor(time / every * (1 + 1e-12)) + 1) * (1 - 1e-12);
}

// A run may end at another time than the one that it goes on from, but not
// before it has begun; that of rounding aside.
void check_end(const std::string& file, double from, double end) {
  if (end >= from * (1 - 1e-12)) return;
  throw contact::Error(contact::detail::needs(
      fmt::format("{}: a checkpoint at t = {:.6g} s", file, from),
      fmt::format("--end-time of {:.6g} s or above: this run ends at {:.6g} s",
                  from, end)));
}

}  // namespace

Outcome run_case(const Case& c, const RunOptions& options) {
  Run run{nullptr,
          Recorder(c, options.rows, options.clearance, !options.only_events),
          !options.only_events, options.stop};
  if (options.progress) run.progress.emplace();
  const OutputTimes times(c, options.only_events);
  double every = options.checkpoint_every;
  long i = 1;
  if (options.resume.empty()) {
    run.start(c, options.friction);
    run.recorder.look(*run.simulation);
  } else {
    Checkpoint from = read_checkpoint(options.resume, options.identity);
    const double time = from.simulation.motion.time;
    check_end(options.resume, time, c.end_time);
    run.recorder.restore(std::move(from.memory));
    run.go_on_from(from.simulation, c, options.friction);
    i = times.after(time);
    if (!(every > 0)) every = from.every;
  }
  std::optional<CheckpointWriter> writer;
  if (!options.checkpoint.empty()) {
    writer.emplace(options.checkpoint, options.identity, every);
  }
  double next_checkpoint = every > 0
                               ? checkpoint_after(run.simulation->time(), every)
                               : History::not_yet;
  std::string no_checkpoint;
  for (; i <= times.count(); ++i) {
    if (!run.move_on(times[i])) {
      // How far it came.
      if (run.simulation->time() > run.recorder.memory().last_time) {
        run.recorder.look(*run.simulation);
      }
      break;
    }
    run.recorder.look(*run.simulation);
    if (run.simulation->time() < next_checkpoint) continue;
    next_checkpoint = checkpoint_after(run.simulation->time(), every);
    const SimulationState state = run.simulation->save();
    if (writer) {
      // One that cannot be written costs nothing but itself and later ones:
      // what is behind a row that was cut short could not be found.
      try {
        writer->write(state, run.recorder.memory());
        run.way_on = fmt::format("; --resume {} goes on from t = {:.6g} s",
                                 options.checkpoint, state.motion.time);
      } catch (const contact::Error& error) {
        no_checkpoint = fmt::format("no checkpoints from t = {:.6g} s on: {}",
                                    state.motion.time, error.what());
        writer.reset();
      }
    }
    run.go_on_from(state, c, options.friction);
  }
  Outcome outcome{options.friction,          run.failure,
                  run.simulation->time(),    run.recorder.take_memory(),
                  run.all_counts(),          {},
                  run.simulation->history(), no_checkpoint};
  for (int body = 0; body < static_cast<int>(c.bodies.size()); ++body) {
    outcome.modes.push_back(run.simulation->sample().mode(body));
  }
  return outcome;
}

}  // namespace separation
