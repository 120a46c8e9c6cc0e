#include "separation/case/case_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "libcontact/base/error.hpp"
#include "multibody/system/system.hpp"
#include "separation/case/body_reader.hpp"
#include "separation/case/case_keys.hpp"
#include "separation/case/case_names.hpp"
#include "separation/case/event_reader.hpp"
#include "separation/case/force_reader.hpp"
#include "separation/case/hinge_reader.hpp"
#include "separation/case/hinges/hinge_type.hpp"
#include "separation/case/reading.hpp"
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
  c.end_time = table.number("end_time", Interval::positive());
  c.output_step = table.optional_number("output_step", Interval::positive())
                      .value_or(c.end_time / 200);
  if (c.end_time / c.output_step > most_rows) {
    table.must_be("output_step",
                  fmt::format("{:g} s or above: {:g} rows at most",
                              c.end_time / most_rows, most_rows));
  }
  c.friction = static_cast<FrictionChoice>(
      table.optional_choice("friction", {"full", "ideal", "traditional"})
          .value_or(0));
  options.integrator =
      table.optional_choice("integrator", {"adaptive", "rk4"}).value_or(0) == 0
          ? multibody::Integrator::adaptive
          : multibody::Integrator::rk4;
  const Interval tolerance{1e-14, 1e-2};
  refuse_idle_keys(table, options.integrator);
  options.relative_tolerance =
      table.optional_number("relative_tolerance", tolerance)
          .value_or(options.relative_tolerance);
  options.absolute_tolerance =
      table.optional_number("absolute_tolerance", tolerance)
          .value_or(default_absolute_tolerance);
  options.step = table.optional_number("step", Interval::positive())
                     .value_or(options.step);
  options.longest_step =
      table.optional_number("longest_step", Interval::positive())
          .value_or(options.longest_step);
}

// Of the carrier or of a body of its own.
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
      table->must_be("body_point",
                     "a point off the hinge's axis: on it a lock holds "
                     "nothing");
    }
  }
  return lock;
}

// Copies of a body around an axis through the carrier's origin.
struct Pattern {
  int count = 1;
  Vector3d axis = Vector3d::UnitX();
  double first = 0;

  Matrix3d turn(int copy) const {
    return rotation_of((first + 2 * std::numbers::pi * copy / count) * axis);
  }
};

Pattern read_pattern(const TomlTable& body, const Hinge& hinge) {
  const auto table = body.optional_table("pattern");
  if (!table) return {};
  if (hinge.kind == HingeKind::none) {
    body.needs("pattern", "a hinge");
  }
  return {static_cast<int>(table->integer("count", 2, 1000)),
          direction(*table, "axis"),
          table->optional_number("first", Interval::any()).value_or(0)};
}

Body turned(Body body, const Matrix3d& turn, const Vector3d& carrier_com) {
  Hinge& hinge = body.hinge;
  hinge.carrier_point =
      turn * (hinge.carrier_point + carrier_com) - carrier_com;
  hinge.zero_rotation = turn * hinge.zero_rotation;
  hinge.axis = turn * hinge.axis;
  hinge.carrier_direction = turn * hinge.carrier_direction;
  body.start.rotation = turn * body.start.rotation;
  return body;
}

// Columns are named after bodies, with underscores for blanks.
void check_name(const TomlTable& table, const Case& c,
                const std::string& name) {
  const std::string column = column_name(name);
  const auto refuse_as = [&](const std::string& other) {
    if (column_name(other) != column) return;
    table.must_be("name",
                  other == name
                      ? "a name that no other body has"
                      : fmt::format("a name that is not that of \"{}\" "
                                    "in columns, where blanks are underscores",
                                    other));
  };
  refuse_as(c.carrier.name);
  for (const Body& body : c.bodies) {
    refuse_as(body.group);
    refuse_as(body.rigid.name);
  }
}

// Bodies that the equations of motion cannot take: no inertia in a direction
// that turns, numbers beyond all bounds.
void check_system(const TomlTable& table, const RigidBody& carrier,
                  std::vector<Body> bodies) {
  Case part{};
  part.carrier = carrier;
  part.bodies = std::move(bodies);
  try {
    system_of(part);
  } catch (const contact::Error& error) {
    const std::string message = error.what();
    const auto colon = message.find(": ");
    table.fail(table.has("principal_inertia") ? "principal_inertia" : "inertia",
               colon == message.npos ? message : message.substr(colon + 2));
  }
}

void read_body(const TomlTable& table, const JointLaws& laws,
               contact::SharedLaws& made, Case& c, CaseNames& names) {
  Body body;
  body.rigid = read_rigid_body(table);
  body.group = body.rigid.name;
  if (const auto hinge = table.optional_table("hinge")) {
    body.hinge = read_hinge(*hinge, body.rigid, c.carrier, laws, made);
  }
  body.lock = read_lock(table, body.rigid.com, body.hinge);
  const auto start = table.optional_table("start");
  body.start = read_body_start(start, body.hinge);
  body.start.locked = body.lock.has_value();
  if (body.lock && (body.start.angle_rate != 0 ||
                    body.start.relative_angular_velocity.norm() > 0)) {
    start->must_be(hinge_type(body.hinge).rate_key,
                   "0 while the body is locked");
  }
  check_system(table, c.carrier, {body});
  const Pattern pattern = read_pattern(table, body.hinge);
  std::vector<Body> copies;
  for (int copy = 0; copy < pattern.count; ++copy) {
    const Matrix3d turn =
        pattern.count == 1 ? Matrix3d::Identity() : pattern.turn(copy);
    copies.push_back(pattern.count == 1 ? body
                                        : turned(body, turn, c.carrier.com));
    if (pattern.count > 1) {
      copies.back().rigid.name = fmt::format("{} {}", body.group, copy + 1);
    }
    names.turns.push_back(turn);
    check_name(table, c, body.group);
    check_name(table, c, copies.back().rigid.name);
  }
  c.bodies.insert(c.bodies.end(), copies.begin(), copies.end());
}

// "a after b after a" where an event waits for itself by way of others, which
// is for ever; "" where it does not.
std::string circle_of(const std::vector<Event>& events, int event) {
  std::string text = events[event].name;
  int after = events[event].after;
  // As many steps as there are events, or another circle has been met.
  for (std::size_t i = 0; i < events.size() && after >= 0; ++i) {
    text += " after " + events[after].name;
    if (after == event) return text;
    after = events[after].after;
  }
  return {};
}

void read_events(const TomlTable& file, Case& c, CaseNames& names) {
  const auto tables = file.tables("event");
  for (const TomlTable& table : tables) {
    const std::string name = table.text("name");
    if (std::find(names.events.begin(), names.events.end(), name) !=
        names.events.end()) {
      table.must_be("name", "a name that no other event has");
    }
    names.events.push_back(name);
  }
  for (const TomlTable& table : tables) {
    c.events.push_back(read_event(table, names));
  }
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const std::string circle = circle_of(c.events, static_cast<int>(i));
    if (circle.empty()) continue;
    tables[i].must_be("after", fmt::format("an event that does not wait "
                                           "for this one: {}",
                                           circle));
  }
}

void read_forces(const TomlTable& file, const CaseNames& names, Case& c) {
  std::set<std::string> taken;
  for (const TomlTable& table : file.tables("force")) {
    if (!taken.insert(table.text("name")).second) {
      table.must_be("name", "a name that no other force has");
    }
    for (Force& force : read_force(table, names)) {
      c.forces.push_back(std::move(force));
    }
  }
}

void read_clearance(const TomlTable& file, const CaseNames& names, Case& c) {
  const auto tables = file.tables("clearance");
  const auto add = [&](int a, int b) {
    c.clearance.push_back({std::min(a, b), std::max(a, b)});
  };
  const auto shaped = [&](const TomlTable& table, std::string_view key) {
    auto bodies = names.rigid_bodies_of(table, key);
    if (c.rigid_body(bodies.front()).shapes.empty()) {
      table.must_be(key, "a body with shapes");
    }
    return bodies;
  };
  for (const TomlTable& table : tables) {
    const auto of_a = shaped(table, "a");
    const auto of_b = shaped(table, "b");
    if (of_a.size() == 1 && of_a == of_b) {
      table.must_be("b", "another body than a");
    }
    for (const int a : of_a) {
      for (const int b : of_b) {
        if (a != b) add(a, b);
      }
    }
  }
  if (tables.empty()) {
    const int count = static_cast<int>(c.bodies.size()) + 1;
    for (int a = 0; a < count; ++a) {
      for (int b = a + 1; b < count; ++b) {
        if (!c.rigid_body(a).shapes.empty() && !c.rigid_body(b).shapes.empty())
          add(a, b);
      }
    }
  }
  const auto order = [](const Case::Pair& p, const Case::Pair& q) {
    return std::pair(p.a, p.b) < std::pair(q.a, q.b);
  };
  std::sort(c.clearance.begin(), c.clearance.end(), order);
  c.clearance.erase(std::unique(c.clearance.begin(), c.clearance.end(),
                                [](const Case::Pair& p, const Case::Pair& q) {
                                  return p.a == q.a && p.b == q.b;
                                }),
                    c.clearance.end());
}

Case whole_case(const TomlTable& file, const JointLaws& laws) {
  contact::SharedLaws made;
  Case c = case_of_file(file, laws, made);
  c.content = file.canonical_text();
  return c;
}

}  // namespace

Case case_of_file(const TomlTable& file, const JointLaws& laws,
                  contact::SharedLaws& made) {
  Case c;
  c.file = file.source();
  c.name = file.text("name");
  read_run(file.table("run"), c);
  c.options.gravity = vector_or_zero(file, "gravity");
  const TomlTable carrier = file.table("carrier");
  c.carrier = read_carrier(carrier);
  if (c.carrier.fixed && file.tables("body").empty()) {
    carrier.needs("fixed", "one or more [[body]]");
  }
  check_system(carrier, c.carrier, {});
  c.carrier_start = read_carrier_start(carrier, c.carrier.fixed);
  if (const auto drive = carrier.optional_table("drive")) {
    c.options.carrier_drive = {vector_or_zero(*drive, "acceleration"),
                               vector_or_zero(*drive, "angular_acceleration")};
  }
  CaseNames names{c, {}, {}};
  for (const TomlTable& body : file.tables("body")) {
    read_body(body, laws, made, c, names);
  }
  read_events(file, c, names);
  read_forces(file, names, c);
  read_clearance(file, names, c);
  file.refuse_idle();
  return c;
}

Case read_case(const std::filesystem::path& path, const JointLaws& laws,
               const contact::KeySettings& settings) {
  return whole_case(TomlTable::from_file(path, case_keys(), settings), laws);
}

Case parse_case(std::string_view text, const std::string& source,
                const JointLaws& laws, const contact::KeySettings& settings,
                const std::filesystem::path& folder) {
  return whole_case(
      TomlTable::from_text(text, source, case_keys(), folder, settings), laws);
}

}  // namespace separation
