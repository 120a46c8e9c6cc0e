#include "separation/case/hinge_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/files/joint_tables.hpp"
#include "separation/case/reading.hpp"

namespace separation {
namespace {

using contact::Error;
using contact::JointContact;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using multibody::HingeKind;

// What is wrong with them is the command line's, not the file's.
void take_laws(const JointLaws& laws, contact::SharedLaws& made,
               contact::JointSpec& joint) {
  const auto take = [&](const char* option, const std::string& name,
                        std::string& law, const auto& make) {
    if (name.empty()) return;
    law = name;
    try {
      make();
    } catch (const Error& error) {
      throw Error(fmt::format("{} {}: joint \"{}\": {}", option, name,
                              joint.name, error.what()));
    }
  };
  take("--law", laws.half_angle, joint.half_angle_law,
       [&] { made.half_angle(joint); });
  take("--pressure", laws.pressure, joint.pressure_law,
       [&] { made.pressure(joint); });
}

contact::JointSpec read_joint_of(const TomlTable& table, const JointLaws& laws,
                                 contact::SharedLaws& made) {
  contact::JointSpec joint = [&] {
    if (!table.has("file")) return contact::joint_from_table(table);
    const auto name = table.optional_text("name");
    try {
      contact::JointSpec read =
          contact::joint_of_file(table.file("file", contact::joint_keys));
      if (name) read.name = *name;
      return read;
    } catch (const Error& error) {
      table.fail("file", error.what());
    }
  }();
  take_laws(laws, made, joint);
  if (!joint.friction) {
    table.needs("[friction], of the joint or of its materials");
  }
  if (std::holds_alternative<contact::FrictionStress>(*joint.friction)) {
    table.needs(
        "[friction] with coefficient and adhesion, or viscous: with a law of "
        "its own joints are for hinge-joint and hinge-duty");
  }
  return joint;
}

HingeJoint read_hinge_joint(const TomlTable& table, const JointLaws& laws,
                            contact::SharedLaws& made) {
  contact::JointSpec joint = read_joint_of(table, laws, made);
  JointContact contact = joint.contact(made);
  return {std::move(joint),
          table.optional_number("position", Interval::any()).value_or(0),
          std::move(contact)};
}

std::optional<contact::JointGroup::Sharing> read_sharing(const TomlTable& table,
                                                         std::size_t joints) {
  if (table.optional_choice("sharing", {"equal"})) {
    table.refuse_both("sharing", "radial_stiffness");
    return contact::JointGroup::Sharing{};  // filled in when the joints are
                                            // known
  }
  auto stiffness = table.optional_numbers("radial_stiffness", {joints},
                                          Interval::positive());
  if (!stiffness) return {};
  return contact::JointGroup::Sharing{
      *std::move(stiffness), table.numbers("axial_share", {joints}, {0, 1})};
}

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
void read_angle(const TomlTable& table, const RigidBody& body,
                const RigidBody& carrier, Hinge& hinge) {
  const auto of_body = table.optional_text("body_direction");
  const auto of_carrier = table.optional_text("carrier_direction");
  if (of_body && of_carrier) {
    hinge.body_direction =
        named_direction(table, "body_direction", body, *of_body);
    hinge.carrier_direction =
        named_direction(table, "carrier_direction", carrier, *of_carrier);
    return;
  }
  if (of_body) table.needs("body_direction", "carrier_direction");
  if (of_carrier) table.needs("carrier_direction", "body_direction");
  hinge.body_direction = hinge.body_point.norm() > 0
                             ? Vector3d(-hinge.body_point.normalized())
                             : Vector3d::UnitX();
  hinge.carrier_direction = hinge.zero_rotation * hinge.body_direction;
}

bool is_ball(const HingeJoint& joint) {
  return joint.joint.geometry.kind() == contact::JointKind::ball;
}

contact::JointGroup make_group(const Hinge& hinge) {
  std::vector<contact::JointGroup::Member> joints;
  for (const HingeJoint& joint : hinge.joints) {
    joints.push_back({contact::Joint(joint.contact), joint.position});
  }
  auto sharing = hinge.sharing;
  if (sharing && sharing->radial_stiffness.empty()) {
    sharing = contact::JointGroup::Sharing::equal(joints);
  }
  return contact::JointGroup(std::move(joints), std::move(sharing));
}

}  // namespace

Hinge read_hinge(const TomlTable& table, const RigidBody& body,
                 const RigidBody& carrier, const JointLaws& laws,
                 contact::SharedLaws& made) {
  Hinge hinge;
  hinge.kind = table.choice("kind", {"ball", "axis"}) == 0 ? HingeKind::ball
                                                           : HingeKind::axis;
  hinge.name = table.optional_text("name").value_or("hinge");
  hinge.body_point = vector_or_zero(table, "body_point") - body.com;
  hinge.carrier_point = vector_or_zero(table, "carrier_point") - carrier.com;
  hinge.zero_rotation =
      optional_rotation(table, "zero_rotation").value_or(Matrix3d::Identity());
  const bool ball = hinge.kind == HingeKind::ball;
  if (ball) {
    read_angle(table, body, carrier, hinge);
  } else {
    hinge.axis = direction(table, "axis");
  }
  const auto joints = table.tables("joint");
  for (const TomlTable& joint : joints) {
    hinge.joints.push_back(read_hinge_joint(joint, laws, made));
  }
  if (!ball) hinge.sharing = read_sharing(table, joints.size());
  if (ball && joints.size() > 1) {
    table.needs("a single joint: it is a ball hinge");
  }
  if (ball && joints.size() == 1 && !is_ball(hinge.joints[0])) {
    joints[0].must_be("kind", "\"ball\" on a ball hinge");
  }
  if (!ball && joints.size() == 1 && is_ball(hinge.joints[0])) {
    table.needs("one pin, or two joints and more, one of them a ball");
  }
  try {
    make_friction(hinge, FrictionChoice::full);
  } catch (const Error& error) {
    table.fail("joint", error.what());
  }
  return hinge;
}

multibody::HingeFriction make_friction(const Hinge& hinge,
                                       FrictionChoice choice) {
  using multibody::FrictionEstimate;
  if (hinge.joints.empty() || choice == FrictionChoice::ideal) return {};
  const FrictionEstimate estimate = choice == FrictionChoice::traditional
                                        ? FrictionEstimate::traditional
                                        : FrictionEstimate::consistent;
  if (hinge.joints.size() == 1) {
    return multibody::JointFriction{contact::Joint(hinge.joints[0].contact),
                                    estimate};
  }
  return multibody::GroupFriction{make_group(hinge), estimate};
}

}  // namespace separation
