#include "separation/forces/tables.hpp"

namespace separation {
namespace {

/// A motor or a torsion spring on an axis: a moment on the body, the opposite
/// one on its parent, as long as the hinge holds.
struct Motor final : ForceLaw {
  Variable variable;
  Table<double> moment;  ///< about the axis, N m

  void add(const ForceInstant& at,
           std::span<multibody::BodyForce> forces) const override {
    const auto [x, origin] = place_in(variable, at);
    const Eigen::Vector3d m =
        moment(x, origin) * (at.parent().rotation * at.hinge().axis);
    forces[at.body].moment += m;
    forces[at.hinge().on].moment -= m;
  }
  ForceEnds where(const Case& of, int body) const override {
    return {of.bodies[body - 1].hinge.body_point};
  }
  void add_breaks(double begin, std::vector<double>& breaks) const override {
    if (variable == Variable::time) moment.add_breaks(begin, breaks);
  }
  void add_kinks(const ForceInstant& at,
                 std::vector<multibody::KinkedVariable>& to) const override {
    separation::add_kinks(variable, moment.at, at, to);
  }
  bool ends_with_hinge() const override { return true; }
};

std::shared_ptr<const ForceLaw> read_motor(const ForceTable& from) {
  const TomlTable& table = from.table;
  from.refuse_without_axis();
  auto law = std::make_shared<Motor>();
  const RowsOver rows = read_variable(from);
  law->variable = rows.variable;
  if (rows.variable == Variable::none) {
    law->moment = {{0}, {table.number("moment")}};
  } else {
    law->moment = {rows.at, table.numbers("moment", {rows.at.size()})};
  }
  return law;
}

}  // namespace

ForceKind motor() {
  using contact::Dimension;
  return {"motor",
          {{"time", Dimension::time},
           {"angle", Dimension::angle},
           {"moment", Dimension::moment}},
          read_motor};
}

}  // namespace separation
