#include "separation/results/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "multibody/motion/state_check.hpp"
#include "separation/case/system_of.hpp"
#include "separation/results/state_check.hpp"
#include "separation/simulation/torque_margin.hpp"

namespace separation {

using contact::detail::must_be;

Run::Run(Case c, RunOptions options)
    : case_(std::move(c)),
      options_(std::move(options)),
      outputs_(case_, options_.only_events),
      inputs_(inputs_of(case_)),
      recorder_(case_, options_.rows, options_.clearance,
                !options_.only_events),
      simulation_(make_simulation()) {
  watch();
  record();
}

Run::Run(Run& other, RunOptions options)
    : Run(other.case_, std::move(options)) {
  RunState state = other.save();
  simulation_->restore(state.simulation);
  go_on_with(std::move(simulation_), std::move(state.memory));
  next_ = other.next_;
  status_ = other.status_;
  message_ = other.message_;
}

std::unique_ptr<Simulation> Run::make_simulation() const {
  return std::make_unique<Simulation>(case_, friction());
}

void Run::watch() {
  time_ = simulation_->time();
  simulation_->halt_when([this] {
    pace_.note(*simulation_);
    return !recorder_.fault().empty() || is_due_to_stop();
  });
  if (options_.only_events && !options_.progress) return;
  simulation_->watch_steps([this](const multibody::MotionSample& sample) {
    if (!options_.only_events) recorder_.look_between(*simulation_);
    if (!options_.progress) return;
    time_ = sample.time();
    options_.progress(*this);
  });
}

void Run::go_on_with(std::unique_ptr<Simulation> simulation,
                     Recorder::Memory memory) {
  simulation_ = std::move(simulation);
  watch();
  recorder_.restore(std::move(memory));
  recorder_.go_on_with(*simulation_);
  next_ = outputs_.after(time_);
  status_ = Status::running;
  message_.clear();
  end_if_over();
}

bool Run::is_due_to_stop() {
  if (!options_.stop) return false;
  stopped_by_ = options_.stop(counts().steps);
  return !stopped_by_.empty();
}

bool Run::give_up(Status status, std::string why) {
  status_ = status;
  message_ = contact::detail::printable(why, why.npos);
  return false;
}

// False where a distance is not known.
bool Run::is_recorded() {
  return recorder_.fault().empty() ||
         give_up(Status::failed, recorder_.fault());
}

bool Run::record() {
  recorder_.look(*simulation_);
  return is_recorded();
}

// Moves on to `time` with all events on the way; false: status() says why.
bool Run::move_on(double time) {
  for (;;) {
    const Simulation::Stop stop = simulation_->advance_to(time);
    time_ = simulation_->time();
    if (!is_recorded()) return false;
    switch (stop) {
      case Simulation::Stop::time:
        return true;
      case Simulation::Stop::failed:
        return give_up(Status::failed, simulation_->message());
      case Simulation::Stop::halted:
        return give_up(
            Status::stopped,
            fmt::format("t = {:.6g} s: stopped by {} after {} steps: {}", time_,
                        stopped_by_, counts().steps, pace()));
      case Simulation::Stop::event:
        if (!record()) return false;
        recorder_.before(*simulation_, simulation_->happenings());
        if (!simulation_->apply()) {
          return give_up(Status::failed, simulation_->message());
        }
        if (!record() || end_if_over()) return false;
    }
  }
}

// By an event.
bool Run::end_if_over() {
  if (!simulation_->is_over()) return false;
  next_ = outputs_.after(case_.end_time);
  status_ = Status::finished;
  return true;
}

Run::Status Run::advance_to(double time) {
  if (status_ == Status::failed) return status_;
  if (!(time >= time_ - outputs_.instant())) {
    throw contact::Error(must_be(fmt::format("time = {}", time),
                                 fmt::format("{} s or later", time_)));
  }
  if (!outputs_.has(next_)) return status_ = Status::finished;
  use_inputs();
  status_ = Status::running;
  message_.clear();
  for (const long last = outputs_.after(time); next_ < last; ++next_) {
    if (!move_on(outputs_[next_]) || !record()) return status_;
  }
  if (!outputs_.has(next_)) return status_ = Status::finished;
  move_on(time);
  return status_;
}

std::vector<double> Run::input_values() const {
  std::vector<double> values = simulation_->history().inputs;
  values.resize(inputs_.size());
  return values;
}

std::size_t Run::input(const std::string& name) const {
  const auto found = std::ranges::find(inputs_, name, &Input::name);
  if (found == inputs_.end()) {
    std::vector<std::string> names;
    for (const Input& input : inputs_) names.push_back(input.name);
    using contact::detail::printable;
    throw contact::Error(contact::detail::unknown(
        "input", printable(name), contact::detail::nearest(name, names), {}));
  }
  return static_cast<std::size_t>(found - inputs_.begin());
}

void Run::set_inputs(std::vector<double> values) {
  if (values.size() != inputs_.size()) {
    throw contact::Error(must_be(fmt::format("{} inputs", values.size()),
                                 fmt::format("{}", inputs_.size())));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) continue;
    throw contact::Error(
        must_be(fmt::format("{} = {}", inputs_[i].name, values[i]), "finite"));
  }
  // None before the first one other than 0: nothing begins anew for zeros.
  if (values != input_values()) simulation_->set_inputs(std::move(values));
}

// Looks before and after the jump, as at events.
void Run::use_inputs() {
  if (!simulation_->has_new_inputs()) return;
  recorder_.catch_up(*simulation_);
  recorder_.before(*simulation_, {});
  simulation_->use_inputs();
  recorder_.catch_up(*simulation_);
}

std::vector<double> Run::values() const {
  const Rows& rows = memory().rows;
  if (rows.size() > 0 && rows.at(rows.size() - 1, 0) == time_) {
    return {rows.numbers.end() - static_cast<std::ptrdiff_t>(columns().size()),
            rows.numbers.end()};
  }
  Recorder recorder(case_, true, options_.clearance, false);
  recorder.look(*simulation_);
  return recorder.take_memory().rows.numbers;
}

Outcome Run::outcome_with(Recorder::Memory memory) const {
  Outcome outcome{friction(),
                  message_,
                  simulation_->time(),
                  std::move(memory),
                  counts(),
                  {},
                  simulation_->history(),
                  std::make_shared<TorqueMargins>()};
  for (int body = 0; body < static_cast<int>(case_.bodies.size()); ++body) {
    outcome.modes.push_back(simulation_->sample().mode(body));
  }
  return outcome;
}

Outcome Run::end() && {
  if (time_ > memory().last_time) record();
  return outcome_with(recorder_.take_memory());
}

SimulationState Run::renew() {
  use_inputs();
  if (time_ > memory().last_time) recorder_.catch_up(*simulation_);
  SimulationState state = simulation_->save();
  recorder_.go_on_with(*simulation_);
  return state;
}

void Run::restore(RunState state) {
  check_state(state, {case_, columns(), outputs_, options_.rows});
  auto simulation = make_simulation();
  simulation->restore(state.simulation);
  multibody::check_numbers(state.simulation.motion, system_of(case_));
  // Nothing is refused from here on.
  go_on_with(std::move(simulation), std::move(state.memory));
}

Outcome run_case(const Case& c, const RunOptions& options) {
  Run run(c, options);
  run.advance_to(c.end_time);
  return std::move(run).end();
}

}  // namespace separation
