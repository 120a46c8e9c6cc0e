#include "study/model/joint_load.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "libcontact/seat/contact.hpp"

namespace study {
namespace {

using contact::TomlTable;
using Eigen::Vector3d;

constexpr const char* vector_key = "reaction_xyz";

// Reads the reaction and the rate of rotation.
void read_reaction(const TomlTable& load, Load& to) {
  to.rate = load.optional_number("rate").value_or(1);
  if (load.has(vector_key)) {
    for (const char* key : {"reaction", "beta"}) {
      if (load.has(key)) {
        load.must_be(key, "left out beside reaction_xyz, which determines it");
      }
    }
    to.direction = contact::LoadDirection::vector;
    to.reaction = Vector3d(load.numbers(vector_key, {3}).data());
    return;
  }
  to.direction = contact::LoadDirection::angle;
  const double force = load.number("reaction");
  const double beta =
      load.optional_number("beta").value_or(std::numbers::pi / 2);
  to.reaction = force * Vector3d(std::sin(beta), 0, std::cos(beta));
}

// Rejects loads for which the joint's seat has no solution.
void read_seat(const TomlTable& load, const contact::JointGeometry& geometry,
               Load& to) {
  if (load.has("in_seat")) {
    load.must_be("in_seat",
                 "left out: a joint with a [seat] is in it; without_seat = "
                 "true takes the endless one");
  }
  const auto& seat = geometry.seat();
  to.without_seat = load.flag("without_seat");
  if (to.without_seat && !seat) {
    load.needs("without_seat", "a joint with a [seat]");
  }
  if (seat && !to.without_seat && !seat->is_about_z() &&
      to.direction == contact::LoadDirection::angle) {
    load.needs("reaction",
               "a seat about z, which beta is counted from, or reaction_xyz or "
               "without_seat");
  }
  if (load.has("swing") && (!seat || to.without_seat)) {
    load.needs("swing", "a joint in a [seat]");
  }
  to.swing = load.optional_number("swing").value_or(0);
}

void read_placement(const TomlTable& load,
                    const contact::JointGeometry& geometry, Load& to) {
  for (const char* key : {"tilt", "load_at", "slide"}) {
    if (load.has(key) && geometry.kind() != contact::JointKind::pin) {
      load.needs(key, "a pin");
    }
    to.ends_pin = to.ends_pin || load.has(key);
  }
  if (load.has("tilt") && load.has("load_at")) {
    load.must_be("tilt", "left out beside load_at, which finds it");
  }
  if (load.has("twist") && !load.has("tilt")) load.needs("twist", "tilt");
  const double half = geometry.length() / 2;
  contact::Placement& placement = to.placement;
  placement.tilt = {load.optional_number("tilt").value_or(0),
                    load.optional_number("twist").value_or(0), 0};
  placement.place =
      load.optional_number("load_at", {-half, half}).value_or(placement.place);
  placement.axial_velocity = load.optional_number("slide").value_or(0);
  if (!to.ends_pin) return;
  for (const char* key : {"beta", vector_key}) {
    if (!load.has(key)) continue;
    load.must_be(key,
                 "left out beside tilt, load_at and slide: the reaction is "
                 "across the axis");
  }
}

}  // namespace

Load read_load(const TomlTable& load, const contact::JointGeometry& geometry) {
  Load all{};
  read_reaction(load, all);
  read_seat(load, geometry, all);
  read_placement(load, geometry, all);
  return all;
}

Vector3d Load::swung(double angle) const {
  const Vector3d across = Vector3d::UnitZ().cross(reaction);
  const Vector3d axis =
      across.isZero(0) ? Vector3d::UnitY() : Vector3d(across.normalized());
  return Eigen::AngleAxisd(angle, axis) * reaction;
}

contact::DutyCycle swinging(const Load& load,
                            const contact::JointGeometry& geometry) {
  constexpr int count = 48;
  contact::DutyCycle::Rows rows;
  for (int i = 0; i < count; ++i) {
    const double time = static_cast<double>(i) / count;
    rows.times.push_back(time);
    rows.forces.push_back(
        load.swung(load.swing * std::sin(2 * std::numbers::pi * time)));
    rows.motion.push_back(load.angular_velocity());
  }
  rows.period = 1;
  const bool body_has_seat =
      geometry.inner_body() == contact::JointBody::carrier;
  return {rows,
          {.axes = body_has_seat ? contact::JointBody::body
                                 : contact::JointBody::carrier}};
}

}  // namespace study
