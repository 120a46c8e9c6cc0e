#include "separation/case/force_reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "separation/case/reading.hpp"

namespace separation {
namespace {

using Eigen::Vector3d;

// KEY_at (a time), or KEY_at_event with KEY_delay.
Clock read_clock(const TomlTable& table, const CaseNames& names,
                 const std::string& key, const Clock& otherwise) {
  const auto time =
      table.optional_number(key + "_at", Interval::non_negative());
  const int event = names.event_of(table, key + "_at_event");
  const auto delay =
      table.optional_number(key + "_delay", Interval::non_negative());
  table.refuse_both(key + "_at_event", key + "_at");
  if (delay && event < 0) table.needs(key + "_delay", key + "_at_event");
  if (event >= 0) return {0, event, delay.value_or(0)};
  return time ? Clock{*time, -1, 0} : otherwise;
}

// Ends that are known to come before their begins.
void check_clocks(const TomlTable& table, const Force& force) {
  const Clock& begin = force.begin;
  const Clock& end = force.end;
  if (begin.event != end.event) return;
  const bool timed = begin.event < 0;
  const double from = timed ? begin.time : begin.delay;
  const double to = timed ? end.time : end.delay;
  if (to > from) return;
  const char* const key = timed ? "ends_at" : "ends_delay";
  table.must_be(table.has(key) ? key : "ends_at_event",
                fmt::format("later than the force begins, {:.6g} s{}", from,
                            timed ? "" : " after the event"));
}

// A vector, or with a table one for each of its rows.
Table<Vector3d> read_vectors(const TomlTable& table, std::string_view key,
                             const std::vector<double>& at) {
  if (!table.has(key)) return {{0}, {Vector3d::Zero()}};
  if (at.empty()) return {{0}, {vector(table, key)}};
  const auto numbers = table.numbers(key, {at.size(), 3}, Interval::any());
  Table<Vector3d> result{at, {}};
  for (std::size_t i = 0; i < numbers.size(); i += 3) {
    result.values.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }
  return result;
}

// Rows over `time` or `angle`; none if neither key is there.
struct RowsOver {
  Variable variable = Variable::none;
  std::vector<double> at;
};
RowsOver read_variable(const TomlTable& table, multibody::HingeKind hinge) {
  const bool over_time = table.has("time");
  const bool over_angle = table.has("angle");
  table.refuse_both("angle", "time");
  if (over_angle && hinge == multibody::HingeKind::none) {
    table.needs("angle", "a body on a hinge");
  }
  if (over_time) {
    return {Variable::time, times_with_jumps(table, "time")};
  }
  if (over_angle) {
    const auto at = increasing(table, "angle");
    // 180 deg but for the rounding of units.
    constexpr double most = std::numbers::pi * (1 + 1e-15);
    if (hinge == multibody::HingeKind::ball &&
        (at.front() < 0 || at.back() > most)) {
      table.must_be("angle",
                    "0 deg to 180 deg on a ball hinge: it is the "
                    "angle between two directions");
    }
    return {Variable::angle, at};
  }
  return {};
}

AppliedForce read_applied(const TomlTable& table, const RigidBody& body,
                          multibody::HingeKind hinge) {
  AppliedForce force;
  force.inertial =
      table.optional_choice("axes", {"body", "inertial"}).value_or(0) == 1;
  force.point = optional_vector(table, "point").value_or(body.com) - body.com;
  const RowsOver rows = read_variable(table, hinge);
  force.variable = rows.variable;
  if (!table.has("force") && !table.has("moment")) {
    table.needs("force or moment");
  }
  force.force = read_vectors(table, "force", rows.at);
  force.moment = read_vectors(table, "moment", rows.at);
  return force;
}

Motor read_motor(const TomlTable& table) {
  const RowsOver rows = read_variable(table, multibody::HingeKind::axis);
  if (rows.variable == Variable::none) {
    return {rows.variable, {{0}, {table.number("moment", Interval::any())}}};
  }
  return {
      rows.variable,
      {rows.at, table.numbers("moment", {rows.at.size()}, Interval::any())}};
}

Thrust read_thrust(const TomlTable& table, const CaseNames& names,
                   const RigidBody& body) {
  Thrust thrust;
  thrust.point = vector(table, "point") - body.com;
  thrust.force = table.number("thrust", Interval::non_negative()) *
                 direction(table, "direction");
  thrust.cutoff = read_clock(table, names, "cutoff", never);
  thrust.decay =
      table.optional_number("decay", Interval::positive()).value_or(0);
  if (thrust.decay > 0 && thrust.cutoff.event < 0 &&
      std::isinf(thrust.cutoff.time)) {
    table.needs("decay", "cutoff_at or cutoff_at_event");
  }
  return thrust;
}

Vector3d carrier_point(const TomlTable& table, const CaseNames& names,
                       int body) {
  return names.turns[body] * vector(table, "carrier_point") -
         names.of.carrier.com;
}

Spring read_spring(const TomlTable& table, const CaseNames& names,
                   const Vector3d& com, int body) {
  return {vector(table, "point") - com, carrier_point(table, names, body),
          table.number("stiffness", Interval::non_negative()),
          table.number("free_length", Interval::non_negative()),
          table.optional_number("damping_N_s_per_m", Interval::non_negative())
              .value_or(0)};
}

Pusher read_pusher(const TomlTable& table, const CaseNames& names,
                   const Vector3d& com, int body) {
  Pusher pusher;
  pusher.point = vector(table, "point") - com;
  pusher.carrier_point = carrier_point(table, names, body);
  pusher.direction = names.turns[body] * direction(table, "direction");
  pusher.first_force = table.number("first_force", Interval::non_negative());
  pusher.last_force =
      table.optional_number("last_force", Interval::non_negative())
          .value_or(pusher.first_force);
  pusher.stroke = table.number("stroke", Interval::positive());
  return pusher;
}

// Coefficients over the angle, a row for each pressure if there are several.
std::vector<Table<double>> read_coefficients(const TomlTable& table,
                                             std::string_view key,
                                             const std::vector<double>& angles,
                                             std::size_t pressures) {
  std::vector<Table<double>> result;
  if (!table.has(key)) {
    const Table<double> zero{{0}, {0}};
    result.assign(pressures, zero);
  } else if (pressures == 1) {
    result.push_back(
        {angles, table.numbers(key, {angles.size()}, Interval::any())});
  } else {
    const auto numbers =
        table.numbers(key, {pressures, angles.size()}, Interval::any());
    for (std::size_t i = 0; i < pressures; ++i) {
      const auto row = numbers.begin() + i * angles.size();
      result.push_back({angles, {row, row + angles.size()}});
    }
  }
  return result;
}

void read_flow(const TomlTable& table, Aerodynamic& air) {
  if (const auto density = table.optional_number("density_kg_per_m3",
                                                 Interval::non_negative())) {
    table.refuse_both("density_kg_per_m3", "dynamic_pressure");
    air.density = *density;
    air.wind = vector_or_zero(table, "wind");
    return;
  }
  air.flow = direction(table, "flow");
  if (!table.has("time")) {
    air.dynamic_pressure = {
        {0}, {table.number("dynamic_pressure", Interval::non_negative())}};
    return;
  }
  const auto at = times_with_jumps(table, "time");
  air.dynamic_pressure = {at, table.numbers("dynamic_pressure", {at.size()},
                                            Interval::non_negative())};
}

Aerodynamic read_aerodynamic(const TomlTable& table, const RigidBody& body) {
  Aerodynamic air;
  air.axis = direction(table, "axis");
  air.point = optional_vector(table, "point").value_or(body.com) - body.com;
  air.area = table.number("reference_area_m2", Interval::positive());
  air.length = table.optional_number("reference_length", Interval::positive())
                   .value_or(1);
  read_flow(table, air);
  const auto angles = increasing(table, "angle");
  air.pressures = {0};
  if (table.has("table_pressure")) {
    air.pressures = increasing(table, "table_pressure");
  }
  const std::size_t rows = air.pressures.size();
  air.axial = read_coefficients(table, "axial", angles, rows);
  air.normal = read_coefficients(table, "normal", angles, rows);
  air.moment = read_coefficients(table, "moment", angles, rows);
  return air;
}

}  // namespace

std::vector<Force> read_force(const TomlTable& table, const CaseNames& names) {
  const std::size_t kind = table.choice(
      "kind",
      {"applied", "thrust", "spring", "pusher", "motor", "aerodynamic"});
  Force force;
  force.name = table.text("name");
  force.begin = read_clock(table, names, "starts", Clock{});
  force.end = read_clock(table, names, "ends", never);
  check_clocks(table, force);
  std::vector<Force> result;
  for (const int i : names.rigid_bodies_of(table, "body")) {
    const RigidBody& body = names.of.rigid_body(i);
    const auto hinge =
        i > 0 ? names.of.bodies[i - 1].hinge.kind : multibody::HingeKind::none;
    force.body = i;
    if (i == 0 && body.fixed) {
      table.must_be("body", "a body, not the carrier, which is fixed");
    }
    switch (kind) {
      case 0:
        force.what = read_applied(table, body, hinge);
        break;
      case 1:
        force.what = read_thrust(table, names, body);
        break;
      case 2:
        if (i == 0) table.must_be("body", "a body, not the carrier");
        force.what = read_spring(table, names, body.com, i - 1);
        break;
      case 3:
        if (i == 0) table.must_be("body", "a body, not the carrier");
        force.what = read_pusher(table, names, body.com, i - 1);
        break;
      case 4:
        if (hinge != multibody::HingeKind::axis) {
          table.must_be("body", "a body on an axis");
        }
        force.what = read_motor(table);
        break;
      default:
        force.what = read_aerodynamic(table, body);
    }
    result.push_back(force);
  }
  return result;
}

}  // namespace separation
