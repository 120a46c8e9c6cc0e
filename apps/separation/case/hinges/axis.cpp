#include <cmath>
#include <optional>
#include <utility>

#include "libcontact/base/linear/turn.hpp"
#include "separation/case/hinges/hinge_type.hpp"
#include "separation/case/reading.hpp"

namespace separation {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::optional<contact::JointGroup::Sharing> read_sharing(const TomlTable& table,
                                                         std::size_t joints) {
  if (table.optional_choice("sharing")) {
    table.refuse_both("sharing", "radial_stiffness");
    return contact::JointGroup::Sharing{};  // filled in by make_group()
  }
  auto stiffness = table.optional_numbers("radial_stiffness", {joints});
  if (!stiffness) return {};
  return contact::JointGroup::Sharing{*std::move(stiffness),
                                      table.numbers("axial_share", {joints})};
}

std::optional<contact::ThrustFace> read_thrust_face(const TomlTable& table) {
  const auto face = table.optional_table("thrust_face");
  if (!face) return {};
  const double outer = face->number("outer_radius");
  return contact::ThrustFace(
      face->number("inner_radius", {0, outer, false, true}), outer,
      contact::FrictionLaw(face->number("coefficient"),
                           face->optional_number("adhesion").value_or(0)));
}

void read(const HingeTable& from, Hinge& hinge) {
  hinge.axis = direction(from.table, "axis");
}

void read_joints(const TomlTable& table, Hinge& hinge) {
  hinge.sharing = read_sharing(table, hinge.joints.size());
  hinge.thrust_face = read_thrust_face(table);
  if (hinge.thrust_face && hinge.joints.size() < 2) {
    table.needs("thrust_face", "several pins");
  }
  if (hinge.joints.size() == 1 && is_ball(hinge.joints[0])) {
    table.needs("one pin, or two joints and more, one of them a ball");
  }
}

void read_start(const TomlTable& table, multibody::BodyStart& start) {
  start.angle = table.optional_number("angle").value_or(0);
  start.angle_rate = table.optional_number("rate").value_or(0);
}

void place(const Hinge& hinge, multibody::Body& body) {
  body.hinge_to_carrier_zero = contact::detail::turn_of_z(hinge.axis);
  body.hinge_to_body =
      hinge.zero_rotation.transpose() * body.hinge_to_carrier_zero;
}

// rotation = R(axis, t) zero_rotation
double angle(const Hinge& hinge, const Matrix3d& rotation) {
  const Matrix3d turn = rotation * hinge.zero_rotation.transpose();
  const double sine =
      hinge.axis.dot(Vector3d(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0),
                              turn(1, 0) - turn(0, 1)));
  return std::atan2(sine, turn.trace() - 1);
}

double turn(const Hinge& hinge, const Matrix3d& parent,
            const Vector3d& relative) {
  return (parent * hinge.axis).dot(relative);
}

}  // namespace

HingeType axis_hinge() {
  using contact::Dimension;
  using contact::number_key;
  constexpr auto non_negative = Interval::non_negative();
  constexpr auto positive = Interval::positive();
  return {multibody::HingeKind::axis,
          "axis",
          {{"axis"},
           contact::word_key("sharing", {"equal"}),
           number_key("radial_stiffness", positive),
           number_key("axial_share", {0, 1}),
           contact::table_key(
               "thrust_face",
               {number_key("inner_radius", Dimension::length, non_negative),
                number_key("outer_radius", Dimension::length, positive),
                number_key("coefficient", non_negative),
                number_key("adhesion", Dimension::stress, non_negative)})},
          true,
          "rate",
          read,
          read_joints,
          read_start,
          place,
          angle,
          turn};
}

}  // namespace separation
