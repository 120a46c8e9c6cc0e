#include "separation/case/hinge_reader.hpp"

#include <fmt/format.h>

#include <utility>

#include "libcontact/base/error.hpp"
#include "libcontact/base/file_text.hpp"
#include "libcontact/files/joint_tables.hpp"
#include "libcontact/seat/table.hpp"
#include "separation/case/hinges/hinge_type.hpp"
#include "separation/case/reading.hpp"

namespace separation {
namespace {

using contact::Error;
using contact::JointContact;
using Eigen::Matrix3d;

// Errors in these laws are the command line's, not the file's.
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
        "[friction] with coefficient and adhesion, or viscous: joints with "
        "another friction law are for hinge-joint and hinge-duty");
  }
  return joint;
}

// The seat with a table of its contacts, if loads for one are given. Who refers
// to the seat keeps it.
std::shared_ptr<const contact::SeatJoint> read_seat(
    const TomlTable& table, const contact::JointSpec& joint) {
  const auto loads =
      table.optional_numbers("seat_loads", {2}, Interval::positive());
  const auto kept = table.optional_text("seat_table");
  if (!table.flag("in_seat")) {
    if (loads) table.needs("seat_loads", "in_seat = true");
    if (kept) table.needs("seat_table", "in_seat = true");
    return {};
  }
  if (loads && kept) table.must_be("seat_loads", "left out beside seat_table");
  if (!joint.geometry.seat()) table.needs("in_seat", "a ball with a [seat]");
  if (loads && !((*loads)[1] > (*loads)[0])) {
    table.must_be("seat_loads", "a load and a larger one");
  }
  try {
    auto seat = std::make_shared<contact::SeatJoint>(joint);
    if (loads) {
      seat->use(std::make_shared<const contact::SeatTable>(
          seat->contact(),
          contact::SeatTable::Options{.least_load = (*loads)[0],
                                      .most_load = (*loads)[1]}));
    }
    if (kept) {
      seat->use(std::make_shared<const contact::SeatTable>(
          seat->contact(), joint,
          contact::detail::file_text(table.folder() / *kept)));
    }
    return seat;
  } catch (const Error& error) {
    table.fail(kept ? "seat_table" : "in_seat", error.what());
  }
}

HingeJoint read_hinge_joint(const TomlTable& table, const JointLaws& laws,
                            contact::SharedLaws& made) {
  contact::JointSpec joint = read_joint_of(table, laws, made);
  const double position =
      table.optional_number("position", Interval::any()).value_or(0);
  if (auto seat = read_seat(table, joint)) {
    // The exact laws, which the seat goes by.
    JointContact contact = seat->unbounded().contact();
    return {std::move(joint), position, std::move(contact), std::move(seat)};
  }
  JointContact contact = joint.without_seat().contact(made);
  return {std::move(joint), position, std::move(contact)};
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
  return contact::JointGroup(std::move(joints), std::move(sharing),
                             hinge.thrust_face);
}

}  // namespace

Hinge read_hinge(const TomlTable& table, const RigidBody& body,
                 const RigidBody& carrier, const JointLaws& laws,
                 contact::SharedLaws& made) {
  Hinge hinge;
  std::vector<std::string> names;
  for (const HingeType& type : hinge_types()) names.emplace_back(type.name);
  const HingeType& type = hinge_types()[table.choice("kind", names)];
  hinge.kind = type.kind;
  hinge.name = table.optional_text("name").value_or("hinge");
  hinge.body_point = vector_or_zero(table, "body_point") - body.com;
  hinge.carrier_point = vector_or_zero(table, "carrier_point") - carrier.com;
  hinge.zero_rotation =
      optional_rotation(table, "zero_rotation").value_or(Matrix3d::Identity());
  type.read({table, body, carrier}, hinge);
  for (const TomlTable& joint : table.tables("joint")) {
    hinge.joints.push_back(read_hinge_joint(joint, laws, made));
  }
  type.read_joints(table, hinge);
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
                                    estimate, hinge.joints[0].seat};
  }
  return multibody::GroupFriction{make_group(hinge), estimate};
}

}  // namespace separation
