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
#include "separation/case/reading.hpp"
#include "separation/case/system_of.hpp"

namespace separation {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using multibody::BodyMotion;
using multibody::JointKind;

// Looser than Motion's own: 1e-8 m or rad is more than any case knows.
constexpr double default_absolute_tolerance = 1e-8;

// More rows than anyone looks at, and memory for them.
constexpr double most_rows = 1e6;

// Keys that the other integrator reads.
void refuse_idle_keys(const TomlTable& table,
                      multibody::Integrator integrator) {
  const auto refuse = [&](std::string_view key, Dimension dimension,
                          const char* other) {
    if (!table.has(key, dimension)) return;
    table.fail(key, fmt::format("allowed: with integrator = \"{}\"", other));
  };
  if (integrator == multibody::Integrator::adaptive) {
    refuse("step", Dimension::time, "rk4");
  } else {
    refuse("relative_tolerance", Dimension::number, "adaptive");
    refuse("absolute_tolerance", Dimension::number, "adaptive");
    refuse("longest_step", Dimension::time, "adaptive");
  }
}

void read_run(const TomlTable& table, Case& c) {
  auto& options = c.options;
  c.end_time = table.number("end_time", Interval::positive(), Dimension::time);
  c.output_step =
      table
          .optional_number("output_step", Interval::positive(), Dimension::time)
          .value_or(c.end_time / 200);
  if (c.end_time / c.output_step > most_rows) {
    table.fail("output_step", fmt::format("allowed: {} rows at most",
                                          static_cast<long>(most_rows)));
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
  options.step =
      table.optional_number("step", Interval::positive(), Dimension::time)
          .value_or(options.step);
  options.longest_step =
      table
          .optional_number("longest_step", Interval::positive(),
                           Dimension::time)
          .value_or(options.longest_step);
}

// Of the carrier or of a body of its own.
BodyMotion read_body_start(const std::optional<TomlTable>& table) {
  BodyMotion start{Vector3d::Zero(), Vector3d::Zero(), Matrix3d::Identity(),
                   Vector3d::Zero()};
  if (!table) return start;
  start.position = vector_or_zero(*table, "position", Dimension::length);
  start.velocity = vector_or_zero(*table, "velocity", Dimension::velocity);
  start.rotation =
      optional_rotation(*table, "rotation").value_or(Matrix3d::Identity());
  start.angular_velocity =
      start.rotation *
      vector_or_zero(*table, "angular_velocity", Dimension::angular_velocity);
  return start;
}

multibody::LoadStart read_load_start(const std::optional<TomlTable>& table,
                                     const Hinge& hinge) {
  multibody::LoadStart start;
  start.rotation = hinge.zero_rotation;
  if (hinge.kind == JointKind::none) {
    start.body = read_body_start(table);
  } else if (table && hinge.kind == JointKind::axis) {
    start.angle =
        table->optional_number("angle", Interval::any(), Dimension::angle)
            .value_or(0);
    start.angle_rate = table
                           ->optional_number("rate", Interval::any(),
                                             Dimension::angular_velocity)
                           .value_or(0);
  } else if (table) {
    start.rotation *=
        optional_rotation(*table, "rotation").value_or(Matrix3d::Identity());
    start.relative_angular_velocity =
        vector_or_zero(*table, "angular_velocity", Dimension::angular_velocity);
  }
  return start;
}

std::optional<Lock> read_lock(const TomlTable& load, const Body& body,
                              const Hinge& hinge) {
  const auto table = load.optional_table("lock");
  if (!table) return {};
  if (hinge.kind == JointKind::none) {
    load.fail("lock", "allowed: for a load with a hinge");
  }
  Lock lock{table->optional_text("name").value_or("lock"),
            vector(*table, "load_point", Dimension::length) - body.com};
  const Vector3d arm = lock.load_point - hinge.load_point;
  if (!(arm.norm() > 0)) {
    table->fail("load_point", "allowed: a point apart from the hinge");
  }
  if (hinge.kind == JointKind::axis) {
    const Vector3d axis = hinge.zero_rotation.transpose() * hinge.axis;
    const double scale = lock.load_point.norm() + hinge.load_point.norm();
    // Rounding of the points' entries and of the axis.
    if (!(arm.cross(axis).norm() > 1e-12 * scale)) {
      table->fail("load_point",
                  "allowed: a point off the hinge's axis: on it a lock holds "
                  "nothing");
    }
  }
  return lock;
}

// Copies of a load around an axis through the carrier's origin.
struct Pattern {
  int count = 1;
  Vector3d axis = Vector3d::UnitX();
  double first = 0;

  Matrix3d turn(int copy) const {
    return rotation_of((first + 2 * std::numbers::pi * copy / count) * axis);
  }
};

Pattern read_pattern(const TomlTable& load, const Hinge& hinge) {
  const auto table = load.optional_table("pattern");
  if (!table) return {};
  if (hinge.kind == JointKind::none) {
    load.fail("pattern", "allowed: for a load with a hinge");
  }
  return {static_cast<int>(table->integer("count", 2, 1000)),
          direction(*table, "axis"),
          table->optional_number("first", Interval::any(), Dimension::angle)
              .value_or(0)};
}

Load turned(Load load, const Matrix3d& turn, const Vector3d& carrier_com) {
  Hinge& hinge = load.hinge;
  hinge.carrier_point =
      turn * (hinge.carrier_point + carrier_com) - carrier_com;
  hinge.zero_rotation = turn * hinge.zero_rotation;
  hinge.axis = turn * hinge.axis;
  hinge.carrier_direction = turn * hinge.carrier_direction;
  load.start.rotation = turn * load.start.rotation;
  return load;
}

// Columns are named after bodies, with underscores for blanks.
void check_name(const TomlTable& table, const Case& c,
                const std::string& name) {
  const std::string column = column_name(name);
  const auto refuse_as = [&](const std::string& other) {
    if (column_name(other) != column) return;
    table.fail("name",
               other == name
                   ? "allowed: a name that no other body has"
                   : fmt::format("allowed: a name that is not that of \"{}\" "
                                 "in columns, where blanks are underscores",
                                 other));
  };
  refuse_as(c.carrier.name);
  for (const Load& load : c.loads) {
    refuse_as(load.group);
    refuse_as(load.body.name);
  }
}

// Bodies that the equations of motion cannot take: no inertia in a direction
// that turns, numbers beyond all bounds.
void check_system(const TomlTable& table, const Body& carrier,
                  std::vector<Load> loads) {
  Case part{};
  part.carrier = carrier;
  part.loads = std::move(loads);
  try {
    system_of(part);
  } catch (const contact::Error& error) {
    const std::string message = error.what();
    const auto colon = message.find(": ");
    table.fail(table.has("principal_inertia", Dimension::inertia)
                   ? "principal_inertia"
                   : "inertia",
               colon == message.npos ? message : message.substr(colon + 2));
  }
}

void read_load(const TomlTable& table, const JointLaws& laws,
               contact::SharedLaws& made, Case& c, CaseNames& names) {
  Load load;
  load.body = read_body(table);
  load.group = load.body.name;
  if (const auto hinge = table.optional_table("hinge")) {
    load.hinge = read_hinge(*hinge, load.body, c.carrier, laws, made);
  }
  load.lock = read_lock(table, load.body, load.hinge);
  const auto start = table.optional_table("start");
  load.start = read_load_start(start, load.hinge);
  load.start.locked = load.lock.has_value();
  if (load.lock && (load.start.angle_rate != 0 ||
                    load.start.relative_angular_velocity.norm() > 0)) {
    start->fail(
        load.hinge.kind == JointKind::axis ? "rate" : "angular_velocity",
        "allowed: 0 while the load is locked");
  }
  check_system(table, c.carrier, {load});
  const Pattern pattern = read_pattern(table, load.hinge);
  std::vector<Load> copies;
  for (int copy = 0; copy < pattern.count; ++copy) {
    const Matrix3d turn =
        pattern.count == 1 ? Matrix3d::Identity() : pattern.turn(copy);
    copies.push_back(pattern.count == 1 ? load
                                        : turned(load, turn, c.carrier.com));
    if (pattern.count > 1) {
      copies.back().body.name = fmt::format("{} {}", load.group, copy + 1);
    }
    names.turns.push_back(turn);
    check_name(table, c, load.group);
    check_name(table, c, copies.back().body.name);
  }
  c.loads.insert(c.loads.end(), copies.begin(), copies.end());
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
      table.fail("name", "allowed: a name that no other event has");
    }
    names.events.push_back(name);
  }
  for (const TomlTable& table : tables) {
    c.events.push_back(read_event(table, names));
  }
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const std::string circle = circle_of(c.events, static_cast<int>(i));
    if (circle.empty()) continue;
    tables[i].fail("after", fmt::format("allowed: an event that does not wait "
                                        "for this one: {}",
                                        circle));
  }
}

void read_forces(const TomlTable& file, const CaseNames& names, Case& c) {
  std::set<std::string> taken;
  for (const TomlTable& table : file.tables("force")) {
    if (!taken.insert(table.text("name")).second) {
      table.fail("name", "allowed: a name that no other force has");
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
    auto bodies = names.bodies_of(table, key);
    if (c.body(bodies.front()).shapes.empty()) {
      table.fail(key, "allowed: a body with shapes");
    }
    return bodies;
  };
  for (const TomlTable& table : tables) {
    const auto of_a = shaped(table, "a");
    const auto of_b = shaped(table, "b");
    if (of_a.size() == 1 && of_a == of_b) {
      table.fail("b", "allowed: another body than a");
    }
    for (const int a : of_a) {
      for (const int b : of_b) {
        if (a != b) add(a, b);
      }
    }
  }
  if (tables.empty()) {
    const int count = static_cast<int>(c.loads.size()) + 1;
    for (int a = 0; a < count; ++a) {
      for (int b = a + 1; b < count; ++b) {
        if (!c.body(a).shapes.empty() && !c.body(b).shapes.empty()) add(a, b);
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

Case read_all(const TomlTable& file, const JointLaws& laws) {
  file.refuse_keys_beside(case_keys());
  Case c;
  c.file = file.source();
  c.content = file.canonical_text();
  c.name = file.text("name");
  read_run(file.table("run"), c);
  c.options.gravity = vector_or_zero(file, "gravity", Dimension::acceleration);
  const TomlTable carrier = file.table("carrier");
  c.carrier = read_body(carrier);
  check_system(carrier, c.carrier, {});
  c.carrier_start = read_body_start(carrier.optional_table("start"));
  if (const auto drive = carrier.optional_table("drive")) {
    c.options.carrier_drive = {
        vector_or_zero(*drive, "acceleration", Dimension::acceleration),
        vector_or_zero(*drive, "angular_acceleration",
                       Dimension::angular_acceleration)};
  }
  CaseNames names{c, {}, {}};
  const auto loads = file.tables("load");
  if (loads.empty()) {
    file.fail_missing("load", "a case has one or more [[load]]");
  }
  contact::SharedLaws made;
  for (const TomlTable& load : loads) read_load(load, laws, made, c, names);
  read_events(file, c, names);
  read_forces(file, names, c);
  read_clearance(file, names, c);
  file.refuse_unknown_keys();
  return c;
}

}  // namespace

Case read_case(const std::filesystem::path& path, const JointLaws& laws) {
  return read_all(TomlTable::from_file(path), laws);
}

Case parse_case(std::string_view text, const std::string& source,
                const JointLaws& laws) {
  return read_all(TomlTable::from_text(text, source), laws);
}

}  // namespace separation
