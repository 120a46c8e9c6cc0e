#include <algorithm>
#include <cmath>

#include "separation/forces/tables.hpp"

namespace separation {
namespace {

using Eigen::Vector3d;

/// Air.
struct Aerodynamic final : ForceLaw {
  Vector3d axis;   ///< unit, body axes: the nose
  Vector3d point;  ///< point of reference of the coefficients
  double area;
  double length;
  /// Direction of the air past the body, unit, inertial axes; with a density
  /// instead of a dynamic pressure it follows from the velocity in the wind.
  Vector3d flow = Vector3d::UnitX();
  Table<double> dynamic_pressure;  ///< Pa, over time; empty with a density
  double density = 0;              ///< kg/m^3
  Vector3d wind = Vector3d::Zero();
  /// Coefficients over the angle of attack, one table for each pressure of
  /// `pressures` (at least one); all have the same angles.
  std::vector<double> angles;
  std::vector<double> pressures;
  std::vector<Table<double>> axial, normal, moment;

  // Linear between the pressures of the tables, constant outside.
  double coefficient(const std::vector<Table<double>>& tables, double pressure,
                     double angle) const {
    std::size_t i = 0;
    while (i < pressures.size() && pressures[i] < pressure) ++i;
    if (i == 0) return tables.front()(angle);
    if (i == pressures.size()) return tables.back()(angle);
    const double part =
        (pressure - pressures[i - 1]) / (pressures[i] - pressures[i - 1]);
    return (1 - part) * tables[i - 1](angle) + part * tables[i](angle);
  }

  struct Flow {
    Vector3d towards;     ///< unit; of the air past the body
    double pressure = 0;  ///< dynamic, Pa; 0: there is none
  };
  Flow flow_at(const ForceInstant& at) const {
    if (density == 0) {
      return {flow, dynamic_pressure.at.empty()
                        ? 0
                        : dynamic_pressure(at.time, at.begin)};
    }
    const Vector3d air = wind - at.on().point_velocity(point);
    const double speed = air.norm();
    if (speed == 0) return {flow};
    return {air / speed, density * speed * speed / 2};
  }

  void add(const ForceInstant& at,
           std::span<multibody::BodyForce> forces) const override {
    const multibody::BodyMotion& body = at.on();
    const auto [towards, pressure] = flow_at(at);
    if (pressure == 0) return;
    const Vector3d nose = body.rotation * axis;
    const Vector3d across = towards - towards.dot(nose) * nose;
    const double sine = across.norm();
    const double angle = std::atan2(sine, -towards.dot(nose));
    const Vector3d side =
        sine > 0 ? Vector3d(across / sine) : Vector3d(Vector3d::Zero());
    const auto c = [&](const std::vector<Table<double>>& tables) {
      return coefficient(tables, pressure, angle);
    };
    const double force = pressure * area;
    forces[at.body].add_at(body, body.point(point),
                           force * (c(normal) * side - c(axial) * nose));
    forces[at.body].moment += force * length * c(moment) * nose.cross(side);
  }
  ForceEnds where(const Case&, int) const override { return {point}; }
  void add_breaks(double begin, std::vector<double>& breaks) const override {
    dynamic_pressure.add_breaks(begin, breaks);
    add_passages(begin, breaks);
  }
  // Times at which the pressure passes one of `pressures` between two rows.
  void add_passages(double begin, std::vector<double>& breaks) const {
    const auto& [at, values] = dynamic_pressure;
    for (std::size_t i = 1; i < at.size(); ++i) {
      const auto [low, high] = std::minmax(values[i - 1], values[i]);
      for (const double pressure : pressures) {
        if (!(low < pressure && pressure < high)) continue;
        const double part =
            (pressure - values[i - 1]) / (values[i] - values[i - 1]);
        breaks.push_back(begin + at[i - 1] + part * (at[i] - at[i - 1]));
      }
    }
  }
  void add_kinks(const ForceInstant& at,
                 std::vector<multibody::KinkedVariable>& to) const override {
    const Vector3d nose = at.on().rotation * axis;
    const auto [towards, pressure] = flow_at(at);
    to.push_back(
        {std::atan2(towards.cross(nose).norm(), -towards.dot(nose)), angles});
    if (density > 0) to.push_back({pressure, pressures});
  }
};

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
    result.push_back({angles, table.numbers(key, {angles.size()})});
  } else {
    const auto numbers = table.numbers(key, {pressures, angles.size()});
    for (std::size_t i = 0; i < pressures; ++i) {
      const auto row = numbers.begin() + i * angles.size();
      result.push_back({angles, {row, row + angles.size()}});
    }
  }
  return result;
}

void read_flow(const TomlTable& table, Aerodynamic& air) {
  if (const auto density = table.optional_number("density_kg_per_m3")) {
    table.refuse_both("density_kg_per_m3", "dynamic_pressure");
    air.density = *density;
    air.wind = vector_or_zero(table, "wind");
    return;
  }
  air.flow = direction(table, "flow");
  if (!table.has("time")) {
    air.dynamic_pressure = {{0}, {table.number("dynamic_pressure")}};
    return;
  }
  const auto at = times_with_jumps(table, "time");
  air.dynamic_pressure = {at, table.numbers("dynamic_pressure", {at.size()})};
}

std::shared_ptr<const ForceLaw> read_aerodynamic(const ForceTable& from) {
  const TomlTable& table = from.table;
  auto air = std::make_shared<Aerodynamic>();
  air->axis = direction(table, "axis");
  air->point = from.point_or_com();
  air->area = table.number("reference_area_m2");
  air->length = table.optional_number("reference_length").value_or(1);
  read_flow(table, *air);
  const std::vector<double>& angles = air->angles = increasing(table, "angle");
  air->pressures = {0};
  if (table.has("table_pressure")) {
    air->pressures = increasing(table, "table_pressure");
  }
  const std::size_t rows = air->pressures.size();
  air->axial = read_coefficients(table, "axial", angles, rows);
  air->normal = read_coefficients(table, "normal", angles, rows);
  air->moment = read_coefficients(table, "moment", angles, rows);
  return air;
}

}  // namespace

ForceKind aerodynamic() {
  using contact::Dimension;
  using contact::number_key;
  return {
      "aerodynamic",
      {{"point", Dimension::length},
       {"time", Dimension::time},
       {"angle", Dimension::angle},
       {"axis"},
       number_key("reference_area_m2", Interval::positive()),
       number_key("reference_length", Dimension::length, Interval::positive()),
       {"flow"},
       number_key("dynamic_pressure", Dimension::stress,
                  Interval::non_negative()),
       number_key("density_kg_per_m3", Interval::non_negative()),
       {"wind", Dimension::velocity},
       {"axial"},
       {"normal"},
       {"moment"},
       {"table_pressure", Dimension::stress}},
      read_aerodynamic};
}

}  // namespace separation
