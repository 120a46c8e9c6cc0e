#include <fmt/format.h>

#include <cmath>
#include <string>

#include "libcontact/base/complaint.hpp"
#include "separation/case/hinges/hinge_type.hpp"
#include "separation/case/reading.hpp"

namespace separation {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d named_direction(const TomlTable& table, std::string_view key,
                         const RigidBody& body, const std::string& name) {
  for (const NamedDirection& direction : body.directions) {
    if (direction.name == name) return direction.vector;
  }
  if (body.directions.empty()) {
    table.needs(key, fmt::format("directions of \"{}\"", body.name));
  }
  std::vector<std::string> names;
  for (const NamedDirection& direction : body.directions) {
    names.push_back(direction.name);
  }
  table.must_be(key, fmt::format("a direction of \"{}\": {}", body.name,
                                 contact::detail::either(names)));
}

// Directions of the angle of a ball joint: two named ones, or the line from
// the hinge to the body's centre of mass, which begins at angle 0.
void read(const HingeTable& from, Hinge& hinge) {
  const auto& [table, body, parent] = from;
  const std::string key = parent_key(table, "direction");
  const auto of_body = table.optional_text("body_direction");
  const auto of_parent = table.optional_text(key);
  if (of_body && of_parent) {
    hinge.body_direction =
        named_direction(table, "body_direction", body, *of_body);
    hinge.parent_direction = named_direction(table, key, parent, *of_parent);
    return;
  }
  if (of_body) table.needs("body_direction", key);
  if (of_parent) table.needs(key, "body_direction");
  hinge.body_direction = hinge.body_point.norm() > 0
                             ? Vector3d(-hinge.body_point.normalized())
                             : Vector3d::UnitX();
  hinge.parent_direction = hinge.zero_rotation * hinge.body_direction;
}

void read_joints(const TomlTable& table, Hinge& hinge) {
  if (hinge.joints.size() > 1) {
    table.needs("a single joint: it is a ball hinge");
  }
  if (hinge.joints.size() == 1 && !is_ball(hinge.joints[0])) {
    table.tables("joint")[0].must_be("kind", "\"ball\" on a ball hinge");
  }
}

void read_start(const TomlTable& table, multibody::BodyStart& start) {
  start.rotation *=
      optional_rotation(table, "rotation").value_or(Matrix3d::Identity());
  start.relative_angular_velocity = vector_or_zero(table, "angular_velocity");
}

double angle(const Hinge& hinge, const Matrix3d& rotation) {
  const Vector3d body = rotation * hinge.body_direction;
  return std::atan2(body.cross(hinge.parent_direction).norm(),
                    body.dot(hinge.parent_direction));
}

double turn(const Hinge&, const Matrix3d&, const Vector3d& relative) {
  return relative.norm();
}

}  // namespace

HingeType ball_hinge() {
  using contact::Dimension;
  return {multibody::HingeKind::ball,
          "ball",
          {{"body_direction", Dimension::number, {}, {}, "load_direction"},
           {"carrier_direction"},
           {"parent_direction"}},
          false,
          "angular_velocity",
          read,
          read_joints,
          read_start,
          [](const Hinge&, multibody::Body&) {},
          angle,
          turn};
}

}  // namespace separation
