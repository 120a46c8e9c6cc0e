#include "separation/results/summary.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "libcontact/base/units.hpp"
#include "separation/results/quantities.hpp"

namespace separation {
namespace {

using nlohmann::ordered_json;

// Infinity, for which JSON has no number, as in tables.
void name_infinity(ordered_json& value) {
  if (value.is_structured()) {
    for (ordered_json& item : value) name_infinity(item);
  } else if (value.is_number_float() && std::isinf(value.get<double>())) {
    value = value.get<double>() > 0 ? "inf" : "-inf";
  }
}

template <class T>
void add(std::span<const contact::Quantity<T>> quantities, const T& of,
         ordered_json& to) {
  for (const auto& q : quantities) {
    if (q.exists && !q.exists(of)) continue;
    ordered_json& value = to[summary_name(q)];
    for_numbers(q, of, [&](double number, int k) {
      if (k == 0) {
        value = number;
      } else {
        value.push_back(number);
      }
    });
  }
}

ordered_json joint_json(const HingeJoint& joint, const JointPeaks& peaks) {
  ordered_json j = {{"name", joint.joint.name},
                    {"half_angle_law", joint.contact().half_angle_law().name()},
                    {"pressure_law", joint.contact().pressure_law().name()}};
  add(joint_quantities(), peaks, j);
  return j;
}

ordered_json release_json(const BodyRecord::Release& release) {
  if (release.time == History::not_yet) return nullptr;
  ordered_json j;
  add(release_quantities(), release, j);
  return j;
}

ordered_json note_json(const Note& note) {
  ordered_json j = {
      {"time_s", note.time}, {"body", note.body}, {"what", note.what}};
  if (note.rate != 0) j["rate_deg_per_s"] = note.rate / contact::degree;
  if (note.approach != 0) j["approach_m_per_s"] = note.approach;
  if (note.impulse == 0) return j;
  j["impulse_N_m_s"] = note.impulse;
  j["energy_J"] = note.loss;
  return j;
}

ordered_json body_json(const Case& c, const Outcome& outcome, int number) {
  const Body& body = c.bodies[number];
  const BodyRecord& record = outcome.memory.bodies[number];
  ordered_json j = {{"name", body.rigid.name}};
  if (body.hinge.kind == multibody::HingeKind::none) return j;
  j["hinge"] = body.hinge.name;
  j["mode_at_end"] = multibody::to_string(outcome.modes[number]);
  add(hinge_quantities(), record, j);
  if (body.lock) {
    j["lock"] = body.lock->name;
    add(lock_quantities(), record, j);
  }
  if (!body.hinge.stops.empty()) add(stop_quantities(), record, j);
  if (c.has_latch(number)) add(latch_quantities(), record, j);
  add(body_quantities(), record, j);
  if (body.hinge.margin) {
    add(margin_quantities(), outcome.margins->of(c, number, outcome.friction),
        j);
  }
  j["at_release"] = release_json(record.release);
  j["joints"] = ordered_json::array();
  for (std::size_t i = 0; i < record.joints.size(); ++i) {
    j["joints"].push_back(joint_json(body.hinge.joints[i], record.joints[i]));
  }
  return j;
}

ordered_json clearance_json(const Case& c, const Outcome& outcome) {
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < c.clearance.size(); ++i) {
    const PairRecord& pair = outcome.memory.pairs[i];
    if (pair.smallest == History::not_yet) continue;
    ordered_json j;
    if (!c.clearance[i].name.empty()) j["name"] = c.clearance[i].name;
    j["a"] = c.rigid_body(c.clearance[i].a).name;
    j["b"] = c.rigid_body(c.clearance[i].b).name;
    j["smallest_m"] = pair.smallest;
    j["time_s"] = pair.time;
    if (pair.overlap_from != History::not_yet) {
      j["overlap_s"] = {pair.overlap_from, pair.overlap_to};
    }
    list.push_back(std::move(j));
  }
  return list;
}

}  // namespace

std::vector<Missed> missed_events(const Case& c, const Outcome& outcome) {
  std::vector<Missed> result;
  for (std::size_t e = 0; e < c.events.size(); ++e) {
    Missed missed{c.events[e].name, {}};
    for (const int body : c.events[e].bodies) {
      if (outcome.history.events[e][body] == History::not_yet) {
        missed.bodies.push_back(c.bodies[body].rigid.name);
      }
    }
    if (!missed.bodies.empty()) result.push_back(std::move(missed));
  }
  return result;
}

ordered_json summary(const Case& c, const Outcome& outcome) {
  const Recorder::Memory& memory = outcome.memory;
  ordered_json j = {{"case", c.name},
                    {"friction", to_string(outcome.friction)},
                    {"end_time_s", outcome.end_time}};
  if (!outcome.failure.empty()) j["failure"] = outcome.failure;
  j["events"] = ordered_json::array();
  for (const Note& note : memory.notes) {
    j["events"].push_back(note_json(note));
  }
  j["missed_events"] = ordered_json::array();
  for (const Missed& missed : missed_events(c, outcome)) {
    j["missed_events"].push_back(
        {{"event", missed.event}, {"bodies", missed.bodies}});
  }
  j["bodies"] = ordered_json::array();
  for (std::size_t i = 0; i < c.bodies.size(); ++i) {
    j["bodies"].push_back(body_json(c, outcome, static_cast<int>(i)));
  }
  for (std::size_t i = 0; i < c.tip_offs.size(); ++i) {
    const auto& [body, event, direction] = c.tip_offs[i];
    const TipOffRecord& record = memory.tip_offs[i];
    if (record.time == History::not_yet) continue;
    ordered_json of = {{"body", c.rigid_body(body).name},
                       {"at", event < 0 ? "end" : c.events[event].name}};
    add(tip_off_quantities(), record, of);
    j["tip_off"].push_back(std::move(of));
  }
  j["clearance"] = clearance_json(c, outcome);
  // A given motion of the carrier does work that no book shows.
  j["energy"] = {{"largest_J", memory.largest_energy},
                 {"largest_drift_J", c.options.carrier_drive
                                         ? ordered_json(nullptr)
                                         : ordered_json(memory.largest_drift)}};
  j["counts"] = {{"steps", outcome.counts.steps},
                 {"evaluations", outcome.counts.evaluations},
                 {"outer_iterations", outcome.counts.outer_iterations},
                 {"not_proven_unique", outcome.counts.unproven}};
  name_infinity(j);
  return j;
}

}  // namespace separation
