#include "separation/case/hinge_reader.hpp"

#include <fmt/format.h>

#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/file_text.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/files/joint_tables.hpp"
#include "separation/case/hinges/hinge_type.hpp"
#include "separation/case/reading.hpp"

namespace separation {
namespace {

using contact::Error;
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

// The joint, with a table of the contacts in its seat if one is asked for.
contact::Joint make_joint(const TomlTable& table,
                          const contact::JointSpec& joint,
                          contact::SharedLaws& made) {
  const auto loads = table.optional_numbers("seat_loads", {2});
  const auto kept = table.optional_text("seat_table");
  for (const char* key : {"seat_loads", "seat_table"}) {
    if (table.has(key) && !joint.geometry.seat()) {
      table.needs(key, "a ball in a [seat]");
    }
  }
  if (loads && kept) table.must_be("seat_loads", "left out beside seat_table");
  if (loads && !((*loads)[1] > (*loads)[0])) {
    table.must_be("seat_loads", "a load and a larger one");
  }
  // Bodies hang on pins that are level and without end, which the contact says.
  if (joint.relief.kind() != contact::Relief::Kind::none) {
    return contact::Joint(joint.contact(made));
  }
  const char* key = table.has("file") ? "file" : "seat";
  try {
    const contact::Joint model(joint, made);
    if (loads) {
      key = "seat_loads";
      return model.tabulated(
          {.least_load = (*loads)[0], .most_load = (*loads)[1]});
    }
    if (kept) {
      key = "seat_table";
      return model.tabulated(
          contact::detail::file_text(table.folder() / *kept));
    }
    return model;
  } catch (const Error& error) {
    if (!joint.geometry.seat()) throw;
    table.fail(key, error.what());
  }
}

HingeJoint read_hinge_joint(const TomlTable& table, const JointLaws& laws,
                            contact::SharedLaws& made) {
  if (table.has("in_seat")) {
    table.must_be("in_seat",
                  "left out: a ball with a [seat] is in it; without_seat = "
                  "true for the endless one");
  }
  contact::JointSpec joint = read_joint_of(table, laws, made);
  if (table.flag("without_seat")) {
    if (!joint.geometry.seat()) {
      table.needs("without_seat", "a joint with a [seat]");
    }
    joint = joint.without_seat();
  }
  const double position = table.optional_number("position").value_or(0);
  contact::Joint model = make_joint(table, joint, made);
  return {std::move(joint), position, std::move(model)};
}

contact::JointGroup make_group(const Hinge& hinge) {
  std::vector<contact::JointGroup::Member> joints;
  for (const HingeJoint& joint : hinge.joints) {
    joints.push_back({joint.model, joint.position});
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
                 const RigidBody& parent, const JointLaws& laws,
                 contact::SharedLaws& made) {
  Hinge hinge;
  const HingeType& type = hinge_types()[table.choice("kind")];
  hinge.kind = type.kind;
  hinge.name = table.optional_text("name").value_or("hinge");
  hinge.body_point = vector_or_zero(table, "body_point") - body.com;
  hinge.parent_point =
      vector_or_zero(table, parent_key(table, "point")) - parent.com;
  hinge.zero_rotation =
      optional_rotation(table, "zero_rotation").value_or(Matrix3d::Identity());
  type.read({table, body, parent}, hinge);
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
  for (const HingeJoint& joint : hinge.joints) {
    if (estimate != FrictionEstimate::traditional || joint.model.is_endless()) {
      continue;
    }
    throw Error(contact::detail::needs(
        fmt::format("friction traditional of joint \"{}\"",
                    contact::detail::printable(joint.joint.name)),
        "without_seat = true: R in the place of R_n knows no rims"));
  }
  if (hinge.joints.size() == 1) {
    return multibody::JointFriction{hinge.joints[0].model, estimate};
  }
  return multibody::GroupFriction{make_group(hinge), estimate};
}

}  // namespace separation
