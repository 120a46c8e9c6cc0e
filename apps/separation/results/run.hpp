// SPDX-License-Identifier: MIT
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
class TorqueMargins;

/// Called before every step of a run with the number of steps so far; returns
/// the reason to stop, or "" to continue. It may read a flag that another
/// thread or a signal handler sets.
using StopRule = std::function<std::string(long steps)>;

/// Options of a run.
struct RunOptions {
  std::optional<FrictionChoice> friction = {};  ///< none: as in the case
  bool rows = true;                             ///< keep the time history
  bool clearance = true;                        ///< compute distances
  /// Record only events and the end; peaks are over these times.
  bool only_events = false;
  StopRule stop = {};  ///< none: runs to its end
  /// Called at the end of every step; time() and sample() then refer to it.
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
  std::shared_ptr<TorqueMargins> margins;   ///< not null
};

/// State from which a run can continue.
struct RunState {
  SimulationState simulation;
  Recorder::Memory memory;
};

/// A running case: its motion, its events and their records. It writes no
/// files. Runs share no data: each may have its own thread.
///
/// The later motion is bit-identical, independent of intermediate stops and
/// queries.
class Run {
 public:
  /// Sets up the run at its start, with the first row.
  /// @throws contact::Error if the motion cannot begin
  explicit Run(Case c, RunOptions options = {});
  /// The later motion of a copy is bit-identical: copying restarts the steps of
  /// both runs, like save().
  Run(Run& other) : Run(other, other.options_) {}
  /// @param options  equal to the options of the other run, except for its
  ///                 callbacks
  Run(Run& other, RunOptions options);
  Run& operator=(const Run&) = delete;

  enum class Status {
    running,   ///< has reached the requested time
    finished,  ///< has reached the end of the case
    failed,    ///< cannot continue
    stopped,   ///< by its stop rule, which advance_to() calls again
  };
  /// Advances to `time` or the end of the case, whichever is first, with all
  /// events and output times before; an output time within 1e-9 of the output
  /// step counts as `time`.
  /// @throws contact::Error if `time` is before time()
  Status advance_to(double time);
  Status status() const { return status_; }
  /// Reason and place of a failure or stop.
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
  /// Loads from outside, in an order of their own: forces and moments on
  /// bodies, moments of hinges. 0 at the start.
  const std::vector<Input>& inputs() const { return inputs_; }
  std::vector<double> input_values() const;
  /// Place of an input; throws contact::Error if there is none.
  std::size_t input(const std::string& name) const;
  /// They act from time() on, constant until they are set again; values() at
  /// time() are those before. Their work is part of the active work.
  /// @param values  one for each of inputs()
  /// @throws contact::Error for another number of them, or one that is not
  ///   finite, without a change
  void set_inputs(std::vector<double> values);
  /// The motion at time(); valid until the run advances.
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
  /// Results with a last row at time(), which ends the run.
  Outcome end() &&;

  /// State from which a run of the same case and options continues
  /// bit-identically to this run. Saving restarts the steps, so that a run that
  /// was never saved differs within the tolerances.
  RunState save() { return {renew(), memory()}; }
  /// save() without a copy of memory().
  SimulationState renew();
  /// @throws contact::Error, without a change, if it belongs to another case or
  ///   other options, or no run has such a state
  void restore(RunState state);

 private:
  std::unique_ptr<Simulation> make_simulation() const;
  void go_on_with(std::unique_ptr<Simulation> simulation,
                  Recorder::Memory memory);
  void watch();
  void use_inputs();
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
  const std::vector<Input> inputs_;
  Recorder recorder_;
  std::unique_ptr<Simulation> simulation_;
  long next_ = 1;  // number in outputs_
  Status status_ = Status::running;
  std::string message_;
  std::string stopped_by_;
  Pace pace_;
  double time_ = 0;
};

/// Runs a case from start to end, or to its failure.
/// @throws contact::Error if the motion cannot begin
Outcome run_case(const Case& c, const RunOptions& options = {});

}  // namespace separation
