#include "separation/results/state_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "separation/case/force_law.hpp"

namespace separation {
namespace {

using contact::detail::must_be;

void require(bool holds, const char* what, double value,
             const std::string& rule) {
  if (holds) return;
  throw contact::Error(
      must_be(fmt::format("state.{} = {}", what, value), rule));
}

void check_size(double value, const char* what) {
  require(value >= 0, what, value, "0 or above");
}

void check_flag(int value, const char* what) {
  require(value == 0 || value == 1, what, value, "0 or 1");
}

/// Times of past events.
class Past {
 public:
  explicit Past(double now) : now_(now) {}

  void check(double time, const char* what) const {
    // A peak at the end of a step has its time to rounding.
    require(time >= 0 && time <= now_ * (1 + 1e-12), what, time,
            fmt::format("0 to {} s", now_));
  }
  void check_or_never(double time, const char* what) const {
    if (time != History::not_yet) check(time, what);
  }

 private:
  double now_;
};

bool has_as_many(const RunState& state, const Case& c) {
  const History& history = state.simulation.history;
  const Recorder::Memory& memory = state.memory;
  const std::size_t bodies = c.bodies.size();
  const auto is_of_bodies = [&](const auto& all) {
    return all.size() == bodies;
  };
  const auto same_stops = [](const auto& touches, const Body& body) {
    return touches.size() == body.hinge.stops.size();
  };
  const auto same_joints = [](const BodyRecord& record, const Body& body) {
    return record.joints.size() == body.hinge.joints.size();
  };
  return history.events.size() == c.events.size() &&
         std::ranges::all_of(history.events, is_of_bodies) &&
         history.spent.size() == c.forces.size() &&
         std::ranges::equal(history.touches, c.bodies, same_stops) &&
         (history.inputs.empty() ||
          history.inputs.size() == inputs_of(c).size()) &&
         memory.forces.size() == c.forces.size() &&
         memory.pairs.size() == c.clearance.size() &&
         memory.tip_offs.size() == c.tip_offs.size() &&
         is_of_bodies(memory.modes) &&
         std::ranges::equal(memory.bodies, c.bodies, same_joints);
}

void check_body(const BodyRecord& body, const Past& past) {
  check_size(body.peak_reaction, "bodies.peak_reaction");
  past.check(body.peak_reaction_time, "bodies.peak_reaction_time");
  check_size(body.peak_lock, "bodies.peak_lock");
  past.check(body.peak_lock_time, "bodies.peak_lock_time");
  check_size(body.work, "bodies.work");
  check_size(body.rest_time, "bodies.rest_time");
  check_size(body.peak_stop, "bodies.peak_stop");
  past.check(body.peak_stop_time, "bodies.peak_stop_time");
  check_size(body.impacts, "bodies.impacts");
  check_size(body.stop_impulses, "bodies.stop_impulses");
  check_size(body.largest_impulse, "bodies.largest_impulse");
  check_size(body.stop_loss, "bodies.stop_loss");
  check_size(body.rest_on_stop, "bodies.rest_on_stop");
  check_flag(body.on_stop, "bodies.on_stop");
  check_size(body.peak_latch, "bodies.peak_latch");
  past.check(body.peak_latch_time, "bodies.peak_latch_time");
  check_size(body.latch_impulse, "bodies.latch_impulse");
  check_size(body.latch_loss, "bodies.latch_loss");
  for (const JointPeaks& joint : body.joints) {
    check_size(joint.reaction, "bodies.joints.reaction");
    past.check(joint.reaction_time, "bodies.joints.reaction_time");
    check_size(joint.pressure, "bodies.joints.pressure");
    check_size(joint.hidden, "bodies.joints.hidden");
    check_size(joint.half_angle, "bodies.joints.half_angle");
    check_size(joint.moment, "bodies.joints.moment");
    require(joint.lower_gap >= 0 && joint.upper_gap >= 0, "bodies.joints.gap",
            joint.least_gap(), "0 or more");
    past.check(joint.rim_time, "bodies.joints.rim_time");
  }
  past.check_or_never(body.release.time, "bodies.release.time");
}

void check_pair(const PairRecord& pair, const Past& past) {
  require(!std::isnan(pair.smallest), "pairs.smallest", pair.smallest,
          "a number");
  past.check(pair.time, "pairs.time");
  past.check_or_never(pair.overlap_from, "pairs.overlap_from");
  past.check(pair.overlap_to, "pairs.overlap_to");
}

void check_force(const ForceRecord& force, const ForceLaw& law,
                 const Past& past) {
  require(
      force.fault >= 0 && force.fault <= static_cast<int>(law.faults().size()),
      "forces.fault", force.fault, "a fault");
  past.check(force.fault_time, "forces.fault_time");
}

void check_history(const History& history, const Past& past) {
  for (const auto& event : history.events) {
    for (const double time : event) past.check_or_never(time, "events");
  }
  for (const char spent : history.spent) {
    check_flag(spent, "spent");
  }
  for (const auto& touches : history.touches) {
    for (const double rate : touches) check_size(rate, "touches");
  }
  for (const double input : history.inputs) {
    require(std::isfinite(input), "inputs", input, "finite");
  }
}

void check_mode(double number, const char* what) {
  for (const auto mode : multibody::hinge_modes) {
    if (number == static_cast<int>(mode)) return;
  }
  require(false, what, number, "the number of a mode");
}

// Every output time has a row, but for the end, which may have been another.
void check_rows(const Rows& rows, double now, const OutputTimes& outputs) {
  const std::size_t width = rows.columns.size();
  std::vector<std::size_t> modes;
  for (std::size_t i = 0; i < width; ++i) {
    if (rows.columns[i].ends_with(".mode")) modes.push_back(i);
  }
  double before = 0;
  long next = 0;  // number of the output
  const auto comes_before = [&](double time) {
    return outputs.has(next + 1) && outputs[next] < time - outputs.instant();
  };
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const double time = rows.at(row, 0);
    require(time >= before && time <= now && !comes_before(time), "rows.time_s",
            time, "that of the next row");
    for (const std::size_t i : modes) check_mode(rows.at(row, i), "rows.mode");
    if (time == outputs[next]) ++next;
    before = time;
  }
  const bool ends_late = comes_before(std::nextafter(now, History::not_yet));
  require(rows.numbers.size() % width == 0 && !ends_late, "rows.size",
          static_cast<double>(rows.size()),
          fmt::format("that of all up to {} s", now));
}

void check_notes(const std::vector<Note>& notes, const Case& c,
                 const Past& past) {
  double before = 0;
  for (const Note& note : notes) {
    past.check(note.time, "notes.time");
    require(note.time >= before, "notes.time", note.time,
            "in the order of time");
    require(std::isfinite(note.rate), "notes.rate", note.rate, "finite");
    check_size(note.impulse, "notes.impulse");
    require(std::isfinite(note.approach), "notes.approach", note.approach,
            "finite");
    check_size(note.loss, "notes.loss");
    before = note.time;
    if (can_be_noted(note, c)) continue;
    throw contact::Error(
        must_be("state.notes.what = " + contact::detail::printable(note.what),
                "an event that a body of the case can have"));
  }
}

void check_memory(const Recorder::Memory& memory, const Case& c,
                  const Past& past) {
  past.check(memory.last_time, "last_time");
  for (const int mode : memory.modes) check_mode(mode, "modes");
  for (const BodyRecord& body : memory.bodies) check_body(body, past);
  for (const PairRecord& pair : memory.pairs) check_pair(pair, past);
  for (const TipOffRecord& tip_off : memory.tip_offs) {
    past.check_or_never(tip_off.time, "tip_offs.time");
  }
  for (std::size_t i = 0; i < memory.forces.size(); ++i) {
    check_force(memory.forces[i], *c.forces[i].law, past);
  }
}

}  // namespace

void check_state(const RunState& state, const StateOwner& owner) {
  const Recorder::Memory& memory = state.memory;
  if (!has_as_many(state, owner.of) || memory.rows.columns != owner.columns ||
      !memory.begun || (!owner.rows && !memory.rows.numbers.empty())) {
    throw contact::Error(must_be("the state to restore",
                                 "of a run of the same case and options"));
  }
  const double now = state.simulation.motion.time;
  const double end = owner.of.end_time;
  // An end that rounding puts before it is the same.
  require(now >= 0 && now <= end * (1 + 1e-12), "time", now,
          fmt::format("0 to {} s", end));
  const Past past(now);
  check_history(state.simulation.history, past);
  check_memory(memory, owner.of, past);
  check_notes(memory.notes, owner.of, past);
  if (owner.rows) check_rows(memory.rows, now, owner.outputs);
}

}  // namespace separation
