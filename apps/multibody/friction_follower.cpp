#include "multibody/friction_follower.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "multibody/eigen_conversion.hpp"

namespace multibody {
namespace {

using contact::JointContact;
using Eigen::Vector3d;

// Contacts of a hinge that can be followed.
std::vector<JointContact> contacts_of(const HingeFriction& friction) {
  constexpr auto consistent = FrictionEstimate::consistent;
  std::vector<JointContact> contacts;
  if (const auto* ball = std::get_if<BallFriction>(&friction)) {
    if (ball->estimate == consistent) contacts.push_back(ball->joint.contact());
  } else if (const auto* pin = std::get_if<PinFriction>(&friction)) {
    if (pin->estimate == consistent) contacts.push_back(pin->joint.contact());
  } else if (const auto* node = std::get_if<NodeFriction>(&friction)) {
    if (node->estimate != consistent) return contacts;
    for (const contact::NodeJoint& joint : node->node.joints()) {
      contacts.push_back(
          std::visit([](const auto& j) { return j.contact(); }, joint.joint));
    }
  }
  return contacts;
}

bool is_ball(const JointContact& contact) {
  return contact.geometry().kind() == contact::JointKind::spherical;
}

bool has_node(const std::vector<HingeFriction>& friction) {
  return std::ranges::any_of(friction, [](const HingeFriction& f) {
    return std::holds_alternative<NodeFriction>(f);
  });
}

// In the order of the hinges; of nodes balls first: only they need integrals.
std::vector<JointContact> all_contacts(
    const std::vector<HingeFriction>& friction) {
  std::vector<JointContact> all;
  for (const HingeFriction& f : friction) {
    for (JointContact& contact : contacts_of(f)) {
      all.push_back(std::move(contact));
    }
  }
  if (has_node(friction)) std::ranges::stable_partition(all, is_ball);
  return all;
}

}  // namespace

FrictionFollower::FrictionFollower(const std::vector<HingeFriction>& friction)
    : joints_(all_contacts(friction)) {
  int next = 0;
  int next_pin = 0;
  const bool balls_first = has_node(friction);
  for (const HingeFriction& f : friction) {
    for (const JointContact& c : contacts_of(f)) next_pin += is_ball(c);
  }
  for (const HingeFriction& f : friction) {
    const std::vector<JointContact> contacts = contacts_of(f);
    Hinge& hinge = hinges_.emplace_back();
    hinge.first = parts_.size();
    hinge.count = contacts.size();
    hinge.is_axis = !std::holds_alternative<BallFriction>(f);
    for (const JointContact& contact : contacts) {
      const bool late = balls_first && !is_ball(contact);
      parts_.push_back({late ? next_pin++ : next++, 1, 0, 1});
    }
    if (const auto* node = std::get_if<NodeFriction>(&f); node && hinge.count) {
      hinge.is_node = true;
      set_shares(node->node, hinge);
    }
    is_direct_ = is_direct_ && hinge.count == 1 && !balls_first;
  }
}

// What a node makes of forces and moments of 1.
void FrictionFollower::set_shares(const contact::JointNode& node,
                                  const Hinge& hinge) {
  const std::size_t count = hinge.count;
  std::vector<Vector3d> radial(count), moment(count), axial(count);
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(),
                 z = Vector3d::UnitZ(), none = Vector3d::Zero();
  node.distribute(x, none, z, none, radial);
  node.distribute(none, y, z, none, moment);
  node.distribute(z, none, z, none, axial);
  for (std::size_t k = 0; k < count; ++k) {
    Part& part = parts_[hinge.first + k];
    part = {part.joint, radial[k].x(), moment[k].x(), axial[k].z()};
    joints_.set_feedback(part.joint, part.moment);
  }
}

void FrictionFollower::start(int hinge, const HingeSolver& solver,
                             const Vector3d& rate) {
  count_ -= follows(hinge);
  const std::span<const Part> all = parts(hinge);
  for (std::size_t k = 0; k < all.size(); ++k) {
    joints_.start(all[k].joint, solver.joints()[k], rate);
    joints_.set_acting_moment(all[k].joint,
                              solver.joint_moment(static_cast<int>(k)));
  }
  count_ += follows(hinge);
}

void FrictionFollower::forget(int hinge) {
  count_ -= follows(hinge);
  for (const Part& part : parts(hinge)) joints_.forget(part.joint);
}

bool FrictionFollower::follows(int hinge) const {
  const std::span<const Part> all = parts(hinge);
  return !all.empty() && std::ranges::all_of(all, [&](const Part& part) {
    return joints_.follows(part.joint);
  });
}

// Of a node only the sum of the joints' moments along the axis is known: the
// first joint takes what it has changed by.
void FrictionFollower::set_acting_moment(int hinge, const Vector3d& moment) {
  const int joint = parts(hinge)[0].joint;
  if (!hinges_[hinge].is_node) {
    joints_.set_acting_moment(joint, moment);
    return;
  }
  Vector3d first = joints_.acting_moment(joint);
  first.z() += moment.z() - acting_moment(hinge).z();
  joints_.set_acting_moment(joint, first);
}

void FrictionFollower::take_reactions(const Dynamics& dynamics,
                                      std::span<const int> hinges,
                                      std::span<Reaction<double>> reactions) {
  if (is_direct_) {
    dynamics.forces(vector_rows(joints_.reactions()));
    return;
  }
  dynamics.reactions(reactions);
  for (const int i : hinges) {
    if (hinges_[i].is_node) {
      set_node_reactions(parts(i), reactions[i]);
    } else {
      const Vec3<double>& force = reactions[i].force;
      joints_.set_reaction(
          parts(i)[0].joint,
          Vector3d(force.x, force.y, hinges_[i].is_axis ? 0 : force.z));
    }
  }
}

void FrictionFollower::set_node_reactions(std::span<const Part> parts,
                                          const Reaction<double>& reaction) {
  const auto& [force, moment] = reaction;
  // Moments normal to the axis load the node as well.
  double cross_x = 0;
  double cross_y = 0;
  for (const Part& part : parts) {
    const Vector3d acting = joints_.acting_moment(part.joint);
    cross_x += acting.x();
    cross_y += acting.y();
  }
  const double held_x = moment.y - cross_y;
  const double held_y = cross_x - moment.x;
  for (const Part& part : parts) {
    joints_.set_reaction(part.joint,
                         Vector3d(part.radial * force.x + part.moment * held_x,
                                  part.radial * force.y + part.moment * held_y,
                                  part.axial * force.z));
  }
}

void FrictionFollower::move(Dynamics& dynamics, std::span<const int> hinges,
                            std::span<Vec3<double>> change) {
  if (is_direct_) {
    dynamics.add_friction(vector_rows(joints_.actions()));
    return;
  }
  for (const int i : hinges) {
    if (!hinges_[i].is_axis) {
      change[i] = vec3(joints_.action(parts(i)[0].joint));
      continue;
    }
    double sum = 0;
    for (const Part& part : parts(i)) sum += joints_.action(part.joint).z();
    change[i] = {0, 0, sum};
  }
  dynamics.add_friction(change);
}

}  // namespace multibody
