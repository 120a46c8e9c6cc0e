#include "separation/simulation/force_watch.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <map>

namespace separation {
namespace {

using Eigen::Vector3d;
using Fault = ForceRecord::Fault;
using multibody::BodyMotion;
using multibody::HingeMode;

// Of a pusher that begins. A thousandth of the stroke, and of directions a
// tenth, are what figures of some digits leave. Where a body on a hinge is
// driven its centre of mass does not tell.
Fault fault_of(const Pusher& pusher, const BodyMotion& carrier,
               const BodyMotion& body, bool is_free) {
  const Vector3d direction = carrier.rotation * pusher.direction;
  const Vector3d at_body = body.point(pusher.point);
  const Vector3d at_carrier = carrier.point(pusher.carrier_point);
  if ((at_body - at_carrier).dot(direction) < -1e-3 * pusher.stroke) {
    return Fault::behind;
  }
  const Vector3d to_body = body.position - at_body;
  const Vector3d to_carrier = carrier.position - at_carrier;
  const bool inwards = is_free &&
                       to_body.dot(direction) < -0.1 * to_body.norm() &&
                       to_carrier.dot(direction) > 0.1 * to_carrier.norm();
  return inwards ? Fault::inwards : Fault::none;
}

double length_of(const Spring& spring, const BodyMotion& carrier,
                 const BodyMotion& body) {
  return (body.point(spring.point) - carrier.point(spring.carrier_point))
      .norm();
}

Fault find_fault(const Force& force, const Simulation& simulation,
                 bool begins) {
  const auto& sample = simulation.sample();
  const BodyMotion& carrier = sample.carrier();
  const BodyMotion& body = sample.motions()[force.body];
  if (const auto* pusher = std::get_if<Pusher>(&force.what)) {
    // Where the middle of a fixed carrier is nobody says.
    const bool is_free = sample.mode(force.body - 1) == HingeMode::released &&
                         !simulation.of().carrier.fixed;
    return begins ? fault_of(*pusher, carrier, body, is_free) : Fault::none;
  }
  const auto* spring = std::get_if<Spring>(&force.what);
  if (spring == nullptr || !(spring->stiffness > 0)) return Fault::none;
  const double length = length_of(*spring, carrier, body);
  // Of places that are some 1e3 m at most: their rounding.
  if (begins && length < 1e-12 && spring->free_length > 0) {
    return Fault::no_direction;
  }
  const Hinge& hinge = simulation.of().bodies[force.body - 1].hinge;
  const bool has_come_off = hinge.kind != multibody::HingeKind::none &&
                            sample.mode(force.body - 1) == HingeMode::released;
  // Longer than rounding of lengths and tolerances of steps make it.
  const bool pulls = length > (1 + 1e-6) * spring->free_length;
  return has_come_off && pulls ? Fault::pulls_back : Fault::none;
}

std::string fault_text(const std::string& body, const ForceRecord& record) {
  const double time = record.fault_time;
  switch (record.fault) {
    case Fault::none:
      break;
    case Fault::behind:
      return fmt::format(
          "pushes {} and the carrier together: when it starts, t = {:.6g} s, "
          "point is behind carrier_point as seen along direction",
          body, time);
    case Fault::inwards:
      return fmt::format(
          "pushes {} and the carrier together: when it starts, t = {:.6g} s, "
          "direction leads from {} to the carrier",
          body, time, body);
    case Fault::no_direction:
      return fmt::format(
          "has no direction when it starts, t = {:.6g} s: point on {} and "
          "carrier_point are in one place",
          time, body);
    case Fault::pulls_back:
      return fmt::format(
          "pulls {} back after its release, from t = {:.6g} s: it is longer "
          "than free_length; ends_at_event ends it, a pusher only pushes",
          body, time);
  }
  return {};
}

}  // namespace

void look_at_forces(const Simulation& simulation,
                    std::vector<ForceRecord>& records) {
  const auto& sample = simulation.sample();
  for (std::size_t f = 0; f < records.size(); ++f) {
    ForceRecord& record = records[f];
    const Force& force = simulation.of().forces[f];
    const bool watched = record.fault == Fault::none &&
                         std::holds_alternative<Spring>(force.what);
    if (record.acted && !watched) continue;
    const auto now = simulation.force(static_cast<int>(f), sample.motions());
    if (!now) continue;
    record.acted |= !now->force.isZero(0) || !now->moment.isZero(0);
    const bool begins = !record.on;
    record.on = true;
    if (record.fault != Fault::none) continue;
    record.fault = find_fault(force, simulation, begins);
    record.fault_time = sample.time();
  }
}

std::vector<std::string> force_faults(const Case& c,
                                      const std::vector<ForceRecord>& records) {
  std::vector<std::string> texts;
  for (std::size_t f = 0; f < records.size(); ++f) {
    if (records[f].fault == Fault::none) continue;
    texts.push_back(fmt::format(
        "force \"{}\" {}", c.forces[f].name,
        fault_text(c.rigid_body(c.forces[f].body).name, records[f])));
  }
  return texts;
}

std::vector<std::string> idle_forces(const Case& c, const History& history,
                                     const std::vector<ForceRecord>& records,
                                     double end_time) {
  // One sentence for all bodies of a force that nothing came of in one way.
  constexpr std::array<const char*, 3> ways = {
      "did not begin for {}", "never acted on {}",
      "never acted on {}: its stroke was used up when it started"};
  std::map<std::pair<std::string, std::size_t>, std::vector<std::string>> idle;
  for (std::size_t f = 0; f < records.size(); ++f) {
    if (records[f].acted) continue;
    const Force& force = c.forces[f];
    const bool began = history.time_of(force.begin, force.body, c) < end_time;
    const bool used_up = history.spent[f] && !records[f].on;
    const std::size_t way = !began ? 0 : used_up ? 2 : 1;
    idle[{force.name, way}].push_back(c.rigid_body(force.body).name);
  }
  std::vector<std::string> texts;
  for (const auto& [key, bodies] : idle) {
    texts.push_back(
        fmt::format("force \"{}\" ", key.first) +
        fmt::format(fmt::runtime(ways[key.second]), fmt::join(bodies, ", ")));
  }
  return texts;
}

}  // namespace separation
