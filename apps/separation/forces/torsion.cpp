#include "separation/case/system_of.hpp"
#include "separation/forces/tables.hpp"

namespace separation {
namespace {

/// A torsion spring on an axis, with a damper: a moment on the body, the
/// opposite one on its parent, as long as the hinge holds,
///
///     M = M0 + k (free - phi) - c phi',
///
/// or with a table over the angle instead of the first two terms. Its energy is
/// counted from `free_angle`, or from the table's first row.
struct Torsion final : ForceLaw {
  double stiffness = 0;   ///< k, N m
  double free_angle = 0;  ///< rad
  double preload = 0;     ///< M0, N m
  double damping = 0;     ///< c, N m s
  IntegratedTable table;  ///< N m, empty: none

  double moment(double angle) const {
    return table.at.empty() ? preload + stiffness * (free_angle - angle)
                            : table(angle);
  }

  void add(const ForceInstant& at,
           std::span<multibody::BodyForce> forces) const override {
    const Hinge& hinge = at.hinge();
    const Eigen::Vector3d axis = at.parent().rotation * hinge.axis;
    const double rate =
        axis.dot(at.on().angular_velocity - at.parent().angular_velocity);
    const Eigen::Vector3d m =
        (moment(hinge_angle(hinge, at.parent(), at.on())) - damping * rate) *
        axis;
    forces[at.body].moment += m;
    forces[hinge.on].moment -= m;
  }
  ForceEnds where(const Case& of, int body) const override {
    return {of.bodies[body - 1].hinge.body_point};
  }
  void add_kinks(const ForceInstant& at,
                 std::vector<multibody::KinkedVariable>& to) const override {
    if (!table.at.empty()) {
      separation::add_kinks(Variable::angle, table.at, at, to);
    }
  }
  bool ends_with_hinge() const override { return true; }

  bool stores() const override { return true; }
  double stored(const ForceInstant& at) const override {
    const double angle = hinge_angle(at.hinge(), at.parent(), at.on());
    return table.at.empty() ? work_to(free_angle - angle)
                            : -table.integral(angle);
  }

 private:
  double work_to(double turn) const {
    return turn * (preload + stiffness * turn / 2);
  }
};

std::shared_ptr<const ForceLaw> read_torsion(const ForceTable& from) {
  const TomlTable& table = from.table;
  from.refuse_without_axis();
  auto law = std::make_shared<Torsion>();
  law->damping = table.optional_number("damping_N_m_s_per_rad").value_or(0);
  if (table.has("angle")) {
    for (const char* key : {"stiffness_N_m_per_rad", "free_angle", "preload"}) {
      table.refuse_both(key, "angle");
    }
    const auto at = increasing(table, "angle");
    law->table = {at, table.numbers("moment", {at.size()})};
    return law;
  }
  if (table.has("moment")) table.needs("moment", "angle");
  law->stiffness = table.number("stiffness_N_m_per_rad");
  law->free_angle = table.optional_number("free_angle").value_or(0);
  law->preload = table.optional_number("preload").value_or(0);
  return law;
}

}  // namespace

ForceKind torsion() {
  using contact::Dimension;
  constexpr auto non_negative = Interval::non_negative();
  return {"torsion",
          {contact::number_key("stiffness_N_m_per_rad", non_negative),
           {"free_angle", Dimension::angle},
           {"preload", Dimension::moment},
           contact::number_key("damping_N_m_s_per_rad", non_negative),
           {"angle", Dimension::angle},
           {"moment", Dimension::moment}},
          read_torsion};
}

}  // namespace separation
