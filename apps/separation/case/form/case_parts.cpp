#include "separation/case/form/case_parts.hpp"

#include <fmt/format.h>

#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "libcontact/base/error.hpp"
#include "multibody/system/system.hpp"
#include "separation/case/body_reader.hpp"
#include "separation/case/hinge_reader.hpp"
#include "separation/case/hinges/hinge_type.hpp"
#include "separation/case/reading.hpp"
#include "separation/case/stop_reader.hpp"
#include "separation/case/system_of.hpp"

namespace separation {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using multibody::BodyMotion;
using multibody::HingeKind;

// Looser than Motion's own: 1e-8 m or rad is more than any case knows.
constexpr double default_absolute_tolerance = 1e-8;

// Keys that the other integrator reads.
void refuse_idle_keys(const TomlTable& table,
                      multibody::Integrator integrator) {
  const auto refuse = [&](std::string_view key, const char* other) {
    if (table.has(key)) table.needs(key, other);
  };
  if (integrator == multibody::Integrator::adaptive) {
    refuse("step", "integrator = \"rk4\"");
  } else {
    for (const char* key :
         {"relative_tolerance", "absolute_tolerance", "longest_step"}) {
      refuse(key, "integrator = \"adaptive\"");
    }
  }
}

void read_run(const TomlTable& table, Case& c) {
  auto& options = c.options;
  c.end_time = table.number("end_time");
  c.output_step =
      table.optional_number("output_step").value_or(c.end_time / 200);
  if (c.end_time / c.output_step > most_rows) {
    table.must_be("output_step",
                  fmt::format("{:g} s or above: {:g} rows at most",
                              c.end_time / most_rows, most_rows));
  }
  c.friction = static_cast<FrictionChoice>(
      table.optional_choice("friction").value_or(0));
  options.integrator = table.optional_choice("integrator").value_or(0) == 0
                           ? multibody::Integrator::adaptive
                           : multibody::Integrator::rk4;
  refuse_idle_keys(table, options.integrator);
  options.relative_tolerance = table.optional_number("relative_tolerance")
                                   .value_or(options.relative_tolerance);
  options.absolute_tolerance = table.optional_number("absolute_tolerance")
                                   .value_or(default_absolute_tolerance);
  options.step = table.optional_number("step").value_or(options.step);
  options.longest_step =
      table.optional_number("longest_step").value_or(options.longest_step);
}

// Start of the carrier or of a body of its own.
BodyMotion read_free_start(const std::optional<TomlTable>& table) {
  BodyMotion start{Vector3d::Zero(), Vector3d::Zero(), Matrix3d::Identity(),
                   Vector3d::Zero()};
  if (!table) return start;
  start.position = vector_or_zero(*table, "position");
  start.velocity = vector_or_zero(*table, "velocity");
  start.rotation =
      optional_rotation(*table, "rotation").value_or(Matrix3d::Identity());
  start.angular_velocity =
      start.rotation * vector_or_zero(*table, "angular_velocity");
  return start;
}

BodyMotion read_carrier_start(const TomlTable& carrier, bool fixed) {
  const auto table = carrier.optional_table("start");
  if (table && fixed) {
    for (const char* key : {"velocity", "angular_velocity"}) {
      if (table->has(key)) {
        table->must_be(key, "left out: the carrier is fixed");
      }
    }
  }
  return read_free_start(table);
}

multibody::BodyStart read_body_start(const std::optional<TomlTable>& table,
                                     const Hinge& hinge) {
  multibody::BodyStart start;
  start.rotation = hinge.zero_rotation;
  if (hinge.kind == HingeKind::none) {
    start.body = read_free_start(table);
  } else if (table) {
    hinge_type(hinge).read_start(*table, start);
  }
  return start;
}

std::optional<Lock> read_lock(const TomlTable& body, const Vector3d& com,
                              const Hinge& hinge) {
  const auto table = body.optional_table("lock");
  if (!table) return {};
  if (hinge.kind == HingeKind::none) {
    body.needs("lock", "a hinge");
  }
  Lock lock{table->optional_text("name").value_or("lock"),
            vector(*table, "body_point") - com};
  const Vector3d arm = lock.body_point - hinge.body_point;
  if (!(arm.norm() > 0)) {
    table->must_be("body_point", "a point apart from the hinge");
  }
  if (hinge.kind == HingeKind::axis) {
    const Vector3d axis = hinge.zero_rotation.transpose() * hinge.axis;
    const double scale = lock.body_point.norm() + hinge.body_point.norm();
    // Rounding of the points' entries and of the axis.
    if (!(arm.cross(axis).norm() > 1e-12 * scale)) {
      table->must_be(
          "body_point",
          "a point off the hinge's axis: on the axis a lock holds nothing");
    }
  }
  return lock;
}

// Bodies that the equations of motion cannot take: no inertia in a direction
// that turns, numbers beyond all bounds.
void check_system(const TomlTable& table, const Case& part) {
  try {
    system_of(part);
  } catch (const contact::Error& error) {
    const std::string message = error.what();
    const auto colon = message.find(": ");
    table.fail(inertia_key(table),
               colon == message.npos ? message : message.substr(colon + 2));
  }
}

void check_carrier(const TomlTable& table, const RigidBody& carrier) {
  Case part{};
  part.carrier = carrier;
  check_system(table, part);
}

// On a carrier that stands, or, where bodies hang on bodies, beside another
// such body on itself.
void check_body(const TomlTable& table, Body body) {
  Case part{};
  part.carrier.fixed = true;
  part.bodies = {body};
  const auto hinge = table.optional_table("hinge");
  if (hinge && hinge->has("on")) {
    body.hinge.on = 1;
    part.bodies.push_back(body);
  }
  check_system(table, part);
}

}  // namespace

void read_run_of(const TomlTable& file, Case& c) {
  read_run(file.table("run"), c);
  c.options.gravity = vector_or_zero(file, "gravity");
}

void read_carrier_of(const TomlTable& file, Case& c) {
  const TomlTable carrier = file.table("carrier");
  c.carrier = read_carrier(carrier);
  if (c.carrier.fixed && file.tables("body").empty()) {
    carrier.needs("fixed", "one or more [[body]]");
  }
  check_carrier(carrier, c.carrier);
  c.carrier_start = read_carrier_start(carrier, c.carrier.fixed);
  if (const auto drive = carrier.optional_table("drive")) {
    c.options.carrier_drive = {vector_or_zero(*drive, "acceleration"),
                               vector_or_zero(*drive, "angular_acceleration")};
  }
}

Body read_body(const TomlTable& table, const RigidBody& parent,
               const JointLaws& laws, contact::SharedLaws& made) {
  Body body;
  body.rigid = read_rigid_body(table);
  body.group = body.rigid.name;
  if (const auto hinge = table.optional_table("hinge")) {
    body.hinge = read_hinge(*hinge, body.rigid, parent, laws, made);
  }
  if (table.has("pattern") && body.hinge.kind == HingeKind::none) {
    table.needs("pattern", "a hinge");
  }
  body.lock = read_lock(table, body.rigid.com, body.hinge);
  const auto start = table.optional_table("start");
  body.start = read_body_start(start, body.hinge);
  if (const auto hinge = table.optional_table("hinge")) {
    body.hinge.stops = read_stops(*hinge, body.hinge, body.start);
    body.hinge.margin = read_margin(*hinge, body.hinge, body.start);
  }
  body.start.locked = body.lock.has_value();
  if (body.lock && (body.start.angle_rate != 0 ||
                    body.start.relative_angular_velocity.norm() > 0)) {
    start->must_be(hinge_type(body.hinge).rate_key,
                   "0 while the body is locked");
  }
  check_body(table, body);
  return body;
}

void check_beside_flow(const TomlTable& table, const Body& body) {
  Case part{};
  part.carrier.fixed = true;
  part.bodies = {body};
  part.bodies[0].hinge.on = 0;
  part.forces.emplace_back().body = 1;
  part.forces[0].burns = true;
  try {
    system_of(part);
  } catch (const contact::Error&) {
    table.must_be(
        inertia_key(table),
        "above 0 about the line from the hinge to the centre of mass, where "
        "engines burn mass");
  }
}

Pattern read_pattern(const TomlTable& of) {
  const auto table = of.optional_table("pattern");
  if (!table) return {};
  return {static_cast<int>(table->integer("count")), direction(*table, "axis"),
          table->optional_number("first").value_or(0)};
}

Matrix3d Pattern::turn(int copy) const {
  if (count == 1) return Matrix3d::Identity();
  return rotation_of((first + 2 * std::numbers::pi * copy / count) * axis);
}

Body Pattern::copy_of(Body body, int copy, const Vector3d& parent_com) const {
  if (count == 1) return body;
  const Matrix3d turn = this->turn(copy);
  Hinge& hinge = body.hinge;
  hinge.parent_point = turn * (hinge.parent_point + parent_com) - parent_com;
  hinge.zero_rotation = turn * hinge.zero_rotation;
  hinge.axis = turn * hinge.axis;
  hinge.parent_direction = turn * hinge.parent_direction;
  body.start.rotation = turn * body.start.rotation;
  return body;
}

void name_copy(Body& body, int copy) {
  body.rigid.name = fmt::format("{} {}", body.group, copy + 1);
}

}  // namespace separation
