#include "programs/separation/long_run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "cli/progress.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

namespace separation {
namespace {

using Status = Run::Status;

void show(cli::Progress& progress, const Run& run) {
  if (!progress.is_due()) return;
  std::string text = fmt::format("{:.6g} s of {:.6g} s, {} steps, ", run.time(),
                                 run.of().end_time, run.counts().steps);
  if (progress.is_terminal()) {
    text += fmt::format("the last {:.2g} s", run.last_step());
  } else {
    text = "hinge-separation: " + text + run.pace();
  }
  progress.say(text);
}

// Time of the first checkpoint after `time`. It depends only on the time, so
// that an interrupted run has the same checkpoints.
double checkpoint_after(double time, double every) {
  if (!(every > 0)) return History::not_yet;
  // A time just before a checkpoint by rounding counts as the checkpoint.
  return every * (std::floor(time / every * (1 + 1e-12)) + 1) * (1 - 1e-12);
}

// A run may end at another time than the run it resumes, but not before the
// checkpoint, except by rounding.
void check_end(const std::string& file, double from, double end) {
  if (end >= from * (1 - 1e-12)) return;
  throw contact::Error(contact::detail::needs(
      fmt::format("{}: a checkpoint at t = {:.6g} s", file, from),
      fmt::format("--end-time of {:.6g} s or above: this run ends at {:.6g} s",
                  from, end)));
}

// Resumes a run from a checkpoint; returns the interval of checkpoints in that
// run.
double resume(Run& run, const std::string& file, Checkpoint from) {
  check_end(file, from.state.simulation.motion.time, run.of().end_time);
  try {
    run.restore(std::move(from.state));
  } catch (const contact::Error& error) {
    throw contact::Error(fmt::format("{}: {}", file, error.what()));
  }
  return from.every;
}

// Writes the checkpoints of a run.
class Keeper {
 public:
  Keeper(const Checkpoints& checkpoints, double every) {
    if (checkpoints.file.empty()) return;
    file_ = checkpoints.file;
    writer_.emplace(file_, checkpoints.identity, every);
  }
  // The run continues in the same way whether a checkpoint is written or not.
  void keep(Run& run) {
    const SimulationState state = run.renew();
    if (!writer_) return;
    // If a checkpoint cannot be written, only this one and later ones are lost:
    // rows after a truncated row could not be found.
    try {
      writer_->write(state, run.memory());
      way_on_ = fmt::format("; --resume {} continues from t = {:.6g} s", file_,
                            state.motion.time);
    } catch (const contact::Error& error) {
      failure_ = fmt::format("no checkpoints from t = {:.6g} s on: {}",
                             state.motion.time, error.what());
      writer_.reset();
    }
  }
  const std::string& way_on() const { return way_on_; }
  const std::string& failure() const { return failure_; }

 private:
  std::string file_;
  std::optional<CheckpointWriter> writer_;
  std::string way_on_;  // printed if the run is stopped
  std::string failure_;
};

}  // namespace

LongRun run_long(const Case& c, RunOptions options, Checkpoints checkpoints) {
  cli::Progress progress;
  options.progress = [&progress](const Run& run) { show(progress, run); };
  Run run(c, std::move(options));
  double every = checkpoints.every;
  if (checkpoints.from) {
    const double before =
        resume(run, checkpoints.resume, std::move(*checkpoints.from));
    if (!(every > 0)) every = before;
  }
  Keeper keeper(checkpoints, every);
  Status status;
  double next = checkpoint_after(run.time(), every);
  do {
    status = run.advance_to(run.next_output());
    if (status == Status::failed || status == Status::stopped) break;
    if (run.time() < next) continue;
    next = checkpoint_after(run.time(), every);
    keeper.keep(run);
  } while (status != Status::finished);
  LongRun result{std::move(run).end(), keeper.failure()};
  if (status == Status::stopped) result.outcome.failure += keeper.way_on();
  return result;
}

}  // namespace separation
