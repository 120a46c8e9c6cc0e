#include "multibody/friction/friction_follower.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>

#include "multibody/system/eigen_conversion.hpp"

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

}  // namespace

// All contacts as the joints follow them, and the place of each.
struct FrictionFollower::Contacts {
  explicit Contacts(const std::vector<HingeFriction>& friction) {
    std::vector<JointContact> all;
    bool any_node = false;
    for (const HingeFriction& f : friction) {
      std::vector<JointContact> own = contacts_of(f);
      counts.push_back(own.size());
      any_node = any_node || std::holds_alternative<NodeFriction>(f);
      std::ranges::move(own, std::back_inserter(all));
    }
    std::vector<int> order(all.size());
    std::iota(order.begin(), order.end(), 0);
    // Only balls need integrals: where there are nodes, all balls come first.
    if (any_node) {
      std::stable_partition(order.begin(), order.end(), [&](int k) {
        return all[k].geometry().kind() == contact::JointKind::ball;
      });
    }
    place.resize(all.size());
    for (const int k : order) {
      place[k] = static_cast<int>(in_place.size());
      in_place.push_back(std::move(all[k]));
    }
    one_each =
        !any_node && std::ranges::count(counts, 1u) == std::ssize(counts);
  }
  std::vector<std::size_t> counts;  // of the hinges
  std::vector<int> place;
  std::vector<JointContact> in_place;
  bool one_each;
};

FrictionFollower::FrictionFollower(const std::vector<HingeFriction>& friction,
                                   contact::InstructionSet set)
    : FrictionFollower(friction, Contacts(friction), set) {}

FrictionFollower::FrictionFollower(const std::vector<HingeFriction>& friction,
                                   Contacts contacts,
                                   contact::InstructionSet set)
    : joints_(std::move(contacts.in_place), set),
      is_direct_(contacts.one_each) {
  for (const int place : contacts.place) parts_.push_back({place, 1, 0, 1});
  std::size_t first = 0;
  for (std::size_t i = 0; i < friction.size(); ++i) {
    Hinge& hinge = hinges_.emplace_back();
    hinge.first = first;
    hinge.count = contacts.counts[i];
    hinge.is_axis = !std::holds_alternative<BallFriction>(friction[i]);
    const auto* node = std::get_if<NodeFriction>(&friction[i]);
    if (node && hinge.count > 0) {
      hinge.is_node = true;
      set_shares(node->node, hinge);
    }
    first += hinge.count;
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
    dynamics.forces(joints_.reactions());
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
  // Moments normal to the axis body the node as well.
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
    dynamics.add_friction(joints_.actions());
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
