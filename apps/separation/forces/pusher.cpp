#include <algorithm>

#include "separation/case/force_kind.hpp"
#include "separation/forces/line.hpp"

namespace separation {
namespace {

using Eigen::Vector3d;
using multibody::BodyMotion;

constexpr std::string_view pusher_faults[] = {
    "pushes {body} and the carrier together: when it starts, t = {time:.6g} s, "
    "point is behind carrier_point as seen along direction",
    "pushes {body} and the carrier together: when it starts, t = {time:.6g} s, "
    "direction leads from {body} to the carrier",
};

/// A pusher on the carrier that pushes the body along a guide until its stroke
/// is used up.
struct Pusher final : ForceLaw {
  enum Fault { none, behind, inwards };

  Vector3d point;
  Vector3d carrier_point;
  Vector3d direction;  ///< unit, carrier axes
  double first_force;  ///< N, at the beginning of the stroke
  double last_force;   ///< N, at its end
  double stroke;       ///< m

  double stroke_used(int body, std::span<const BodyMotion> bodies) const {
    const BodyMotion& carrier = bodies[0];
    const Vector3d line =
        bodies[body].point(point) - carrier.point(carrier_point);
    return line.dot(carrier.rotation * direction);
  }
  void add(const ForceInstant& at,
           std::span<multibody::BodyForce> forces) const override {
    const double used = stroke_used(at.body, at.bodies);
    const double part = std::clamp(used / stroke, 0.0, 1.0);
    const double force = first_force + part * (last_force - first_force);
    add_opposite({at.body, 0}, at.bodies, at.on().point(point),
                 at.carrier().rotation * (force * direction), forces);
  }
  // Behind its beginning the force does not rise.
  void add_kinks(const ForceInstant& at,
                 std::vector<multibody::KinkedVariable>& to) const override {
    static constexpr double beginning[] = {0};
    to.push_back({stroke_used(at.body, at.bodies), beginning});
  }
  ForceEnds where(const Case&, int) const override {
    return {point, 0, carrier_point};
  }
  std::optional<double> overrun(
      int body, std::span<const BodyMotion> bodies) const override {
    return stroke_used(body, bodies) - stroke;
  }

  std::span<const std::string_view> faults() const override {
    return pusher_faults;
  }
  // A thousandth of the stroke, and a tenth for directions, are the rounding of
  // numbers of a few digits. For a body on a hinge the centre of mass does not
  // show the direction, and a fixed carrier has no centre of mass.
  int find_fault(const ForceInstant& at, bool begins,
                 bool released) const override {
    if (!begins) return none;
    const Vector3d along = at.carrier().rotation * direction;
    const Vector3d at_body = at.on().point(point);
    const Vector3d at_carrier = at.carrier().point(carrier_point);
    if ((at_body - at_carrier).dot(along) < -1e-3 * stroke) return behind;
    const Vector3d to_body = at.on().position - at_body;
    const Vector3d to_carrier = at.carrier().position - at_carrier;
    return released && !at.of.carrier.fixed &&
                   to_body.dot(along) < -0.1 * to_body.norm() &&
                   to_carrier.dot(along) > 0.1 * to_carrier.norm()
               ? inwards
               : none;
  }
};

std::shared_ptr<const ForceLaw> read_pusher(const ForceTable& from) {
  from.refuse_carrier();
  const TomlTable& table = from.table;
  auto law = std::make_shared<Pusher>();
  law->point = from.point();
  law->carrier_point = from.carrier_point();
  law->direction = from.carrier_direction();
  law->first_force = table.number("first_force");
  law->last_force =
      table.optional_number("last_force").value_or(law->first_force);
  law->stroke = table.number("stroke");
  return law;
}

}  // namespace

ForceKind pusher() {
  using contact::Dimension;
  using contact::number_key;
  constexpr auto non_negative = Interval::non_negative();
  return {"pusher",
          {{"point", Dimension::length},
           {"direction"},
           {"carrier_point", Dimension::length},
           number_key("first_force", Dimension::force, non_negative),
           number_key("last_force", Dimension::force, non_negative),
           number_key("stroke", Dimension::length, Interval::positive())},
          read_pusher,
          true};
}

}  // namespace separation
