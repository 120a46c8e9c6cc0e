#include "separation/warnings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <utility>

#include "cli/program.hpp"
#include "separation/output/summary.hpp"
#include "separation/record/contact_limits.hpp"
#include "separation/simulation/force_watch.hpp"

namespace separation {
namespace {

void add_overlaps(const Case& c, const Outcome& outcome, Warnings& warnings) {
  for (std::size_t i = 0; i < c.clearance.size(); ++i) {
    const PairRecord& pair = outcome.memory.pairs[i];
    if (pair.overlap_from == History::not_yet) continue;
    warnings.add(fmt::format("{} and {} overlap from t = {:.6g} s to {:.6g} s",
                             c.rigid_body(c.clearance[i].a).name,
                             c.rigid_body(c.clearance[i].b).name,
                             pair.overlap_from, pair.overlap_to));
  }
}

// Forces that do what was hardly meant.
void add_faults(const Case& c, const Outcome& outcome, Warnings& warnings) {
  for (const std::string& fault : force_faults(c, outcome.memory.forces)) {
    warnings.add(fault);
  }
}

// Events that are in the file for nothing, and forces.
void add_missed(const Case& c, const Outcome& outcome, Warnings& warnings) {
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
void add_drift(const Case& c, const Outcome& outcome, Warnings& warnings) {
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

}  // namespace

void Warnings::add(std::string text) {
  if (aloud_) cli::warn(program_name, text);
  texts_.push_back(std::move(text));
}

void Warnings::note(const std::string& text) const {
  if (aloud_) cli::note(program_name, text);
}

void warn_of_joints(const Case& c, Warnings& warnings) {
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
  for (const std::string& fit : fits) warnings.note(fit);
  for (const std::string& note : notes) warnings.add(note);
}

void warn_of_run(const Case& c, const Outcome& outcome, Warnings& warnings) {
  if (outcome.failure.empty()) {
    add_missed(c, outcome, warnings);
  } else {
    warnings.add("ended early: " + outcome.failure);
  }
  add_faults(c, outcome, warnings);
  for (const std::string& note : contact_notes(c, outcome.memory)) {
    warnings.add(note);
  }
  add_overlaps(c, outcome, warnings);
  add_drift(c, outcome, warnings);
}

void warn_of_replay(Replay& replay, Warnings& warnings) {
  for (const std::string& fault : replay_faults(replay)) warnings.add(fault);
  replay.warnings = warnings.texts();
}

}  // namespace separation
