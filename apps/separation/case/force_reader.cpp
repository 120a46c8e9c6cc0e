#include "separation/case/force_reader.hpp"

#include "separation/case/force_kind.hpp"

namespace separation {
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
  return vector(table, "point") - rigid_body().com;
}

Eigen::Vector3d ForceTable::point_or_com() const {
  const Eigen::Vector3d& com = rigid_body().com;
  return optional_vector(table, "point").value_or(com) - com;
}

Eigen::Vector3d ForceTable::carrier_point() const {
  return names.turns[body - 1] * vector(table, "carrier_point") -
         names.of.carrier.com;
}

Clock ForceTable::clock(const std::string& key, const Clock& otherwise) const {
  return names.clock(table, key, otherwise);
}

Force read_force(const TomlTable& table, const CaseNames& names, int copy) {
  const ForceKind& kind = force_kinds()[table.choice("kind")];
  ForceTable from{table, names, 0, copy, 0};
  const std::string name = table.text("name");
  const auto [begin, end] = names.window(table, "the force");
  Force force{name, 0, begin, end, nullptr};
  const auto bodies = names.rigid_bodies_of(table, "body");
  from.copies = static_cast<int>(bodies.size());
  from.body = force.body = bodies[copy];
  if (force.body == 0 && names.of.carrier.fixed) {
    table.must_be("body", "a body, not the carrier, which is fixed");
  }
  force.law = kind.read(from);
  force.burns = force.law->propellant() != nullptr;
  return force;
}

std::vector<Force> read_forces(const TomlTable& table, const CaseNames& names) {
  std::vector<Force> forces = {read_force(table, names, 0)};
  const auto bodies = names.rigid_bodies_of(table, "body");
  for (std::size_t copy = 1; copy < bodies.size(); ++copy) {
    forces.push_back(read_force(table, names, static_cast<int>(copy)));
  }
  return forces;
}

}  // namespace separation
