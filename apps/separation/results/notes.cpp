#include "separation/results/notes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "libcontact/base/text.hpp"
#include "libcontact/pressure/validity.hpp"
#include "libcontact/seat/contact.hpp"
#include "separation/results/summary.hpp"
#include "separation/simulation/force_watch.hpp"
#include "separation/simulation/torque_margin.hpp"

namespace separation {
namespace {

using contact::detail::printable;
using Texts = std::vector<std::string>;

void add_overlaps(const Case& c, const Outcome& outcome, Texts& texts) {
  for (std::size_t i = 0; i < c.clearance.size(); ++i) {
    const PairRecord& pair = outcome.memory.pairs[i];
    if (pair.overlap_from == History::not_yet) continue;
    texts.push_back(
        fmt::format("{} and {} overlap from t = {:.6g} s to {:.6g} s",
                    c.rigid_body(c.clearance[i].a).name,
                    c.rigid_body(c.clearance[i].b).name, pair.overlap_from,
                    pair.overlap_to));
  }
}

// Adds the faults of forces.
void add_faults(const Case& c, const Outcome& outcome, Texts& texts) {
  for (const std::string& fault : force_faults(c, outcome.memory.forces)) {
    texts.push_back(fault);
  }
}

// Events that are in the file for nothing, and forces. That bodies do not come
// near each other is as it should be.
void add_missed(const Case& c, const Outcome& outcome, Texts& texts) {
  for (const Missed& missed : missed_events(c, outcome)) {
    if (!std::ranges::find(c.events, missed.event, &Event::name)
             ->pairs.empty()) {
      continue;
    }
    texts.push_back(fmt::format("event \"{}\" did not occur for {}",
                                missed.event, fmt::join(missed.bodies, ", ")));
  }
  for (const std::string& idle : idle_forces(
           c, outcome.history, outcome.memory.forces, outcome.end_time)) {
    texts.push_back(idle);
  }
}

// Steps that are too long show in the balance of the energies.
void add_drift(const Case& c, const Outcome& outcome, Texts& texts) {
  const Recorder::Memory& memory = outcome.memory;
  constexpr double notable = 1e-5;
  if (c.options.carrier_drive ||
      !(memory.largest_drift > notable * memory.largest_energy)) {
    return;
  }
  texts.push_back(fmt::format(
      "the energy balance is off by {:.2g} J, {:.2g} of its largest part: use "
      "shorter steps or smaller tolerances",
      memory.largest_drift, memory.largest_drift / memory.largest_energy));
}

void add_unproven(const Outcome& outcome, Texts& texts) {
  const multibody::MotionCounts& counts = outcome.counts;
  if (counts.unproven == 0) return;
  texts.push_back(fmt::format(
      "in {} of {} evaluations friction is so strong that other friction "
      "moments may fit the reactions as well: a search found none",
      counts.unproven, counts.evaluations));
}

// Each warning once, with all bodies that it is about.
void add_margins(const Case& c, const Outcome& outcome, Texts& texts) {
  std::map<std::string, Texts> bodies;
  for (int i = 0; i < static_cast<int>(c.bodies.size()); ++i) {
    const Body& body = c.bodies[i];
    if (!body.hinge.margin) continue;
    for (const std::string& note : margin_notes(
             *body.hinge.margin, outcome.margins->of(c, i, outcome.friction))) {
      bodies[note].push_back(body.rigid.name);
    }
  }
  for (const auto& [note, of] : bodies) {
    texts.push_back(
        fmt::format("torque_margin of {} {}", fmt::join(of, ", "), note));
  }
}

// Calls visit(joint, its body's place, its place there) for all joints.
template <class Visit>
void for_each_joint(const Case& c, const Visit& visit) {
  for (std::size_t b = 0; b < c.bodies.size(); ++b) {
    const auto& joints = c.bodies[b].hinge.joints;
    for (std::size_t j = 0; j < joints.size(); ++j) visit(joints[j], b, j);
  }
}

// Texts of all joints, each once.
template <class TextsOf>
Texts joint_texts(const Case& c, const TextsOf& texts_of) {
  std::set<std::string> texts;
  for_each_joint(c, [&](const HingeJoint& joint, auto... place) {
    for (const std::string& text : texts_of(joint, place...)) {
      texts.insert(fmt::format("joint {}: {}",
                               printable(joint.joint.name, std::string::npos),
                               text));
    }
  });
  return {texts.begin(), texts.end()};
}

// The model of a seat leaves this out beside the rims that were come near to,
// and has no peak of contacts that hide it there.
Texts rim_notes(const HingeJoint& joint, const JointPeaks& peaks) {
  contact::SeatState nearest;
  nearest.status = contact::SeatStatus::ok;
  if (std::isnan(peaks.peak_pressure())) {
    nearest.force = peaks.hidden * Eigen::Vector3d::UnitX();
    nearest.force_ratio = nearest.area = 1;
  }
  const contact::JointGeometry& geometry = joint.contact().geometry();
  for (const auto& [rim, gap] :
       {std::pair(0, peaks.lower_gap), std::pair(1, peaks.upper_gap)}) {
    nearest.rims[rim].distance = gap / geometry.radius();
    nearest.rims[rim].intensity = gap > 0 ? 0 : 1;
  }
  return contact::SeatContact(joint.joint, *geometry.seat()).notes(nearest);
}

}  // namespace

std::vector<std::string> clearance_notes(const Case& c) {
  return joint_texts(c, [](const HingeJoint& joint, auto...) -> Texts {
    return joint.joint.clearance_notes();
  });
}

std::vector<std::string> joint_notes(const Case& c) {
  return joint_texts(c, [](const HingeJoint& joint, auto...) {
    return joint.contact().validity_notes();
  });
}

std::vector<std::string> contact_notes(const Case& c,
                                       const Recorder::Memory& memory) {
  return joint_texts(c, [&](const HingeJoint& joint, auto body, auto place) {
    const JointPeaks& peaks = memory.bodies[body].joints[place];
    Texts texts =
        joint.contact().limits().notes({peaks.half_angle, peaks.pressure});
    if (std::isinf(peaks.least_gap())) return texts;
    for (std::string& note : rim_notes(joint, peaks)) {
      texts.push_back(std::move(note));
    }
    return texts;
  });
}

std::optional<double> pressure_over_limit(const Case& c,
                                          const Recorder::Memory& memory) {
  std::optional<double> most;
  for_each_joint(c, [&](const HingeJoint& joint, auto body, auto place) {
    const double share = memory.bodies[body].joints[place].peak_pressure() /
                         joint.contact().limits().peak_pressure();
    // NaN stays, whatever follows.
    if (!most || (!(share <= *most) && !std::isnan(*most))) most = share;
  });
  return most;
}

std::vector<std::string> run_notes(const Case& c, const Outcome& outcome) {
  Texts texts;
  if (outcome.failure.empty()) {
    add_missed(c, outcome, texts);
  } else {
    texts.push_back("ended early: " + outcome.failure);
  }
  add_faults(c, outcome, texts);
  for (std::string& note : contact_notes(c, outcome.memory)) {
    texts.push_back(std::move(note));
  }
  add_overlaps(c, outcome, texts);
  add_drift(c, outcome, texts);
  add_unproven(outcome, texts);
  add_margins(c, outcome, texts);
  return texts;
}

}  // namespace separation
