#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "separation/results/output_times.hpp"
#include "separation/results/record.hpp"
#include "separation/simulation/pace.hpp"

namespace separation {

class Run;

/// Asked before every step of a run with the number of steps so far: why the
/// run has to stop, "" to go on. It may look at a flag that another thread or a
/// signal handler sets.
using StopRule = std::function<std::string(long steps)>;

/// How a case is run.
struct RunOptions {
  std::optional<FrictionChoice> friction = {};  ///< none: as the case has it
  bool rows = true;                             ///< keep the time history
  bool clearance = true;                        ///< work out distances
  /// Look only at events and at the end; peaks are those of these times.
  bool only_events = false;
  StopRule stop = {};  ///< none: goes on to its end
  /// Called at the end of every step, which time() and sample() are then of.
  std::function<void(const Run&)> progress = {};
};

/// Results of one run.
struct Outcome {
  FrictionChoice friction;
  std::string failure;  ///< reason of an early stop, or ""
  double end_time;      ///< s
  Recorder::Memory memory;
  multibody::MotionCounts counts;
  std::vector<multibody::HingeMode> modes;  ///< at the end
  History history;                          ///< its state at the end
};

/// All that a run needs to go on later.
struct RunState {
  SimulationState simulation;
  Recorder::Memory memory;
};

/// A case on its way: its motion, its events and what is remembered of them.
/// It writes nothing. Runs have nothing in common: each may have a thread.
///
/// Where it stops on the way and what is asked of it there changes nothing of
/// what follows, to the last bit.
class Run {
 public:
  /// At the start, with the row of it.
  /// @throws contact::Error if the motion cannot begin
  explicit Run(Case c, RunOptions options = {});
  /// A copy goes on as the other run does, to the last bit: to take one begins
  /// the steps of both anew, as save() does.
  Run(Run& other) : Run(other, other.options_) {}
  /// @param options  as those of the other run, but for who is asked on the way
  Run(Run& other, RunOptions options);
  Run& operator=(const Run&) = delete;

  enum class Status {
    running,   ///< has come where it was told to
    finished,  ///< has come to the end of the case
    failed,    ///< cannot go on
    stopped,   ///< by its stop rule; advance_to() asks that again
  };
  /// Moves on to `time` or the end of the case, whatever is first, with events
  /// and output times on the way; an output time within 1e-9 of the output
  /// step is `time`.
  /// @throws contact::Error if `time` is before time()
  Status advance_to(double time);
  Status status() const { return status_; }
  /// Why it has failed or was stopped, and where.
  const std::string& message() const { return message_; }

  const Case& of() const { return case_; }
  const RunOptions& options() const { return options_; }
  double time() const { return time_; }
  /// The output time after this one, or the end.
  double next_output() const { return outputs_[next_]; }

  /// Names and values of a row of the history at time().
  const std::vector<std::string>& columns() const {
    return memory().rows.columns;
  }
  std::vector<double> values() const;
  /// The motion at time(): to look at until the run goes on.
  const multibody::MotionSample& sample() const {
    return simulation_->sample();
  }
  /// Rows, events (`notes`) and peaks so far.
  const Recorder::Memory& memory() const { return recorder_.memory(); }

  multibody::MotionCounts counts() const {
    return simulation_->motion().counts();
  }
  double last_step() const { return simulation_->motion().last_step(); }
  /// Text on the limits of its steps: Pace::text().
  std::string pace() const { return pace_.text(*simulation_); }

  /// Results so far.
  Outcome outcome() const { return outcome_with(memory()); }
  /// The same with a last row where it is, which ends the run.
  Outcome end() &&;

  /// A run of the same case and options goes on from there as this one does
  /// from now on, to the last bit; that is a new beginning of the steps, so
  /// that one that was never saved differs by the tolerances.
  RunState save() { return {renew(), memory()}; }
  /// save() without a copy of memory().
  SimulationState renew();
  /// @throws contact::Error, having changed nothing, if it is of another case
  ///   or of other options, or no run has such a state
  void restore(RunState state);

 private:
  std::unique_ptr<Simulation> make_simulation() const;
  void go_on_with(std::unique_ptr<Simulation> simulation,
                  Recorder::Memory memory);
  void watch();
  bool move_on(double time);
  bool record();
  bool is_recorded();
  bool give_up(Status status, std::string why);
  bool is_due_to_stop();
  bool end_if_over();
  FrictionChoice friction() const {
    return options_.friction.value_or(case_.friction);
  }
  Outcome outcome_with(Recorder::Memory memory) const;

  const Case case_;
  const RunOptions options_;
  const OutputTimes outputs_;
  Recorder recorder_;
  std::unique_ptr<Simulation> simulation_;
  long next_ = 1;  // number in outputs_
  Status status_ = Status::running;
  std::string message_;
  std::string stopped_by_;
  Pace pace_;
  double time_ = 0;
};

/// From start to end, or as far as it comes.
/// @throws contact::Error if the motion cannot begin
Outcome run_case(const Case& c, const RunOptions& options = {});

}  // namespace separation
