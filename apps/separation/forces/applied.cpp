#include "separation/forces/tables.hpp"

namespace separation {
namespace {

using Eigen::Vector3d;

/// A force and a moment given by the file.
struct Applied final : ForceLaw {
  bool inertial = false;  ///< axes of force and moment; else the body's
  Vector3d point = Vector3d::Zero();
  Variable variable = Variable::none;
  Table<Vector3d> force;
  Table<Vector3d> moment;

  void add(const ForceInstant& at,
           std::span<multibody::BodyForce> forces) const override {
    const multibody::BodyMotion& body = at.on();
    const auto [x, origin] = place_in(variable, at);
    Vector3d f = force(x, origin);
    Vector3d m = moment(x, origin);
    if (!inertial) {
      f = body.rotation * f;
      m = body.rotation * m;
    }
    forces[at.body].add_at(body, body.point(point), f);
    forces[at.body].moment += m;
  }
  ForceEnds where(const Case&, int) const override { return {point}; }
  void add_breaks(double begin, std::vector<double>& breaks) const override {
    if (variable != Variable::time) return;
    force.add_breaks(begin, breaks);
    moment.add_breaks(begin, breaks);
  }
  // A force or a moment that the file has not is a table of one row.
  void add_kinks(const ForceInstant& at,
                 std::vector<multibody::KinkedVariable>& to) const override {
    const auto& rows =
        force.at.size() < moment.at.size() ? moment.at : force.at;
    separation::add_kinks(variable, rows, at, to);
  }
};

// A vector, or with a table one for each of its rows.
Table<Vector3d> read_vectors(const TomlTable& table, std::string_view key,
                             const std::vector<double>& at) {
  if (!table.has(key)) return {{0}, {Vector3d::Zero()}};
  if (at.empty()) return {{0}, {vector(table, key)}};
  const auto numbers = table.numbers(key, {at.size(), 3});
  Table<Vector3d> result{at, {}};
  for (std::size_t i = 0; i < numbers.size(); i += 3) {
    result.values.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }
  return result;
}

std::shared_ptr<const ForceLaw> read_applied(const ForceTable& from) {
  const TomlTable& table = from.table;
  auto law = std::make_shared<Applied>();
  law->inertial = table.optional_choice("axes").value_or(0) == 1;
  law->point = from.point_or_com();
  const RowsOver rows = read_variable(from);
  law->variable = rows.variable;
  if (!table.has("force") && !table.has("moment")) {
    table.needs("force or moment");
  }
  law->force = read_vectors(table, "force", rows.at);
  law->moment = read_vectors(table, "moment", rows.at);
  if (!law->inertial) {
    for (Vector3d& force : law->force.values) force = from.turn * force;
    for (Vector3d& moment : law->moment.values) moment = from.turn * moment;
  }
  return law;
}

}  // namespace

ForceKind applied() {
  using contact::Dimension;
  return {"applied",
          {{"point", Dimension::length},
           {"time", Dimension::time},
           {"angle", Dimension::angle},
           {"moment", Dimension::moment},
           contact::word_key("axes", {"body", "inertial"}),
           {"force", Dimension::force}},
          read_applied,
          true};
}

}  // namespace separation
