#include "separation/case/force_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "separation/case/body_reader.hpp"
#include "separation/case/force_kind.hpp"
#include "separation/case/form/case_parts.hpp"

namespace separation {
namespace {

const ForceKind& read_kind(const TomlTable& table) {
  return force_kinds()[table.choice("kind")];
}

Pattern pattern_of(const TomlTable& table) {
  return read_kind(table).has_pattern ? read_pattern(table) : Pattern{};
}

// What an engine burns, kg; of one without propellant, begun or ended by an
// event, that is not known before.
double burned_by(const Case& c, const Force& force) {
  const Propellant& propellant = *force.law->propellant();
  if (std::isfinite(propellant.mass)) return propellant.mass;
  const Clock& own = force.law->own_clock();
  if (force.begin.event >= 0 || force.end.event >= 0 || own.event >= 0) {
    return 0;
  }
  const double end = std::min(c.end_time, force.end.time);
  return force.law->impulse_until(std::max(force.begin.time, end),
                                  force.begin.time, own.time) /
         propellant.exhaust_speed;
}

}  // namespace

multibody::HingeKind ForceTable::hinge() const {
  return body > 0 ? names.of.bodies[body - 1].hinge.kind
                  : multibody::HingeKind::none;
}

void ForceTable::refuse_without_axis() const {
  if (hinge() == multibody::HingeKind::axis) return;
  table.must_be("body", "a body on an axis");
}

void ForceTable::refuse_carrier() const {
  if (body == 0) table.must_be("body", "a body, not the carrier");
}

Eigen::Vector3d ForceTable::point() const {
  return turn * vector(table, "point") - rigid_body().com;
}

Eigen::Vector3d ForceTable::point_or_com() const {
  return table.has("point") ? point() : Eigen::Vector3d::Zero();
}

Eigen::Vector3d ForceTable::carrier_point() const {
  return names.turns[body - 1] * turn * vector(table, "carrier_point") -
         names.of.carrier.com;
}

Eigen::Vector3d ForceTable::body_direction() const {
  return turn * direction(table, "direction");
}

Eigen::Vector3d ForceTable::carrier_direction() const {
  return names.turns[body - 1] * body_direction();
}

Clock ForceTable::clock(const std::string& key, const Clock& otherwise) const {
  return names.clock(table, key, otherwise);
}

Force read_force(const TomlTable& table, const CaseNames& names, int copy) {
  const ForceKind& kind = read_kind(table);
  const std::string name = table.text("name");
  const auto [begin, end] = names.window(table, "the force");
  const auto bodies = names.rigid_bodies_of(table, "body");
  const Pattern pattern = pattern_of(table);
  const int place = copy % pattern.count;
  const int number = copy / pattern.count;
  Force force{name, name, bodies[number], begin, end, nullptr};
  if (pattern.count > 1) force.name += ' ' + std::to_string(place + 1);
  if (force.body == 0 && names.of.carrier.fixed) {
    table.must_be("body", "a body, not the carrier, which is fixed");
  }
  force.law = kind.read({table, names, force.body, number,
                         static_cast<int>(bodies.size()), pattern.turn(place)});
  force.burns = force.law->propellant() != nullptr;
  return force;
}

std::vector<Force> read_forces(const TomlTable& table, const CaseNames& names) {
  std::vector<Force> forces;
  const auto count = static_cast<int>(
      names.rigid_bodies_of(table, "body").size() * pattern_of(table).count);
  for (int copy = 0; copy < count; ++copy) {
    forces.push_back(read_force(table, names, copy));
  }
  return forces;
}

void check_propellant(const TomlTable& file, const Case& c) {
  struct Left {
    double mass;
    Eigen::Matrix3d inertia;
  };
  std::map<int, Left> left;
  const auto tables = file.tables("force");
  for (const Force& force : c.forces) {
    const Propellant* burnt = force.law->propellant();
    if (!burnt) continue;
    const TomlTable& table = *std::ranges::find_if(
        tables, [&](const auto& t) { return t.text("name") == force.group; });
    const RigidBody& body = c.rigid_body(force.body);
    auto& [mass, inertia] =
        left.try_emplace(force.body, Left{body.mass, body.inertia})
            .first->second;
    const double burned = burned_by(c, force);
    if (!(burned < mass)) {
      table.fail(table.has("propellant") ? "propellant" : "thrust",
                 fmt::format("what may be burned, {:.6g} kg, must be less than "
                             "the mass that other engines leave, {:.6g} kg of "
                             "{:.6g}",
                             burned, mass, body.mass));
    }
    mass -= burned;
    const Eigen::Matrix3d part =
        burnt->empty_inertia
            ? Eigen::Matrix3d(body.inertia - *burnt->empty_inertia)
            : Eigen::Matrix3d(burned / body.mass * body.inertia);
    if (!is_below(part, inertia)) {
      table.must_be(inertia_key(table, "empty_"),
                    "that of the body without this engine's propellant alone: "
                    "with its other engines it falls below 0");
    }
    inertia -= part;
  }
}

}  // namespace separation
