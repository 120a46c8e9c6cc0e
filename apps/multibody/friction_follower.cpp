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

std::vector<JointContact> all_contacts(
    const std::vector<HingeFriction>& friction) {
  std::vector<JointContact> all;
  for (const HingeFriction& f : friction) {
    for (JointContact& contact : contacts_of(f)) {
      all.push_back(std::move(contact));
    }
  }
  return all;
}

}  // namespace

FrictionFollower::FrictionFollower(const std::vector<HingeFriction>& friction)
    : joints_(all_contacts(friction)), shares_(joints_.size()) {
  int first = 0;
  for (const HingeFriction& f : friction) {
    Hinge& hinge = hinges_.emplace_back();
    hinge.first = first;
    hinge.count = static_cast<int>(contacts_of(f).size());
    hinge.is_axis = !std::holds_alternative<BallFriction>(f);
    if (const auto* node = std::get_if<NodeFriction>(&f); node && hinge.count) {
      hinge.is_node = true;
      set_shares(node->node, first);
    }
    first += hinge.count;
    is_direct_ = is_direct_ && hinge.count == 1 && !hinge.is_axis;
  }
}

// What a node makes of forces and moments of 1.
void FrictionFollower::set_shares(const contact::JointNode& node, int first) {
  const std::size_t count = node.joints().size();
  std::vector<Vector3d> radial(count), moment(count), axial(count);
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(),
                 z = Vector3d::UnitZ(), none = Vector3d::Zero();
  node.distribute(x, none, z, none, radial);
  node.distribute(none, y, z, none, moment);
  node.distribute(z, none, z, none, axial);
  for (std::size_t k = 0; k < count; ++k) {
    shares_[first + k] = {radial[k].x(), moment[k].x(), axial[k].z()};
    joints_.set_feedback(first + static_cast<int>(k), moment[k].x());
  }
}

void FrictionFollower::start(int hinge, const HingeSolver& solver,
                             const Vector3d& rate) {
  const Hinge& h = hinges_[hinge];
  count_ -= follows(hinge);
  for (int k = 0; k < h.count; ++k) {
    joints_.start(h.first + k, solver.joints()[k], rate);
    joints_.set_acting_moment(h.first + k, solver.joint_moment(k));
  }
  count_ += follows(hinge);
}

void FrictionFollower::forget(int hinge) {
  const Hinge& h = hinges_[hinge];
  count_ -= follows(hinge);
  for (int k = 0; k < h.count; ++k) joints_.forget(h.first + k);
}

bool FrictionFollower::follows(int hinge) const {
  const Hinge& h = hinges_[hinge];
  for (int k = 0; k < h.count; ++k) {
    if (!joints_.follows(h.first + k)) return false;
  }
  return h.count > 0;
}

// Of a node only the sum of the joints' moments along the axis is known: the
// first joint takes what it has changed by.
void FrictionFollower::set_acting_moment(int hinge, const Vector3d& moment) {
  const Hinge& h = hinges_[hinge];
  if (!h.is_node) {
    joints_.set_acting_moment(h.first, moment);
    return;
  }
  Vector3d first = joints_.acting_moment(h.first);
  first.z() += moment.z() - acting_moment(hinge).z();
  joints_.set_acting_moment(h.first, first);
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
    const Hinge& h = hinges_[i];
    if (h.is_node) {
      set_node_reactions(h, reactions[i]);
    } else {
      const Vec3<double>& force = reactions[i].force;
      joints_.set_reaction(h.first,
                           Vector3d(force.x, force.y, h.is_axis ? 0 : force.z));
    }
  }
}

void FrictionFollower::set_node_reactions(const Hinge& hinge,
                                          const Reaction<double>& reaction) {
  const auto& [force, moment] = reaction;
  // Moments normal to the axis load the node as well.
  double cross_x = 0;
  double cross_y = 0;
  for (int k = hinge.first; k < hinge.first + hinge.count; ++k) {
    const Vector3d acting = joints_.acting_moment(k);
    cross_x += acting.x();
    cross_y += acting.y();
  }
  const double held_x = moment.y - cross_y;
  const double held_y = cross_x - moment.x;
  for (int k = hinge.first; k < hinge.first + hinge.count; ++k) {
    const Shares& share = shares_[k];
    joints_.set_reaction(
        k, Vector3d(share.radial * force.x + share.moment * held_x,
                    share.radial * force.y + share.moment * held_y,
                    share.axial * force.z));
  }
}

void FrictionFollower::move(Dynamics& dynamics, std::span<const int> hinges,
                            std::span<Vec3<double>> change) {
  if (is_direct_) {
    dynamics.add_friction(vector_rows(joints_.actions()));
    return;
  }
  for (const int i : hinges) {
    const Hinge& h = hinges_[i];
    Vector3d sum = joints_.action(h.first);
    for (int k = h.first + 1; k < h.first + h.count; ++k) {
      sum += joints_.action(k);
    }
    change[i] = h.is_axis ? Vec3<double>{0, 0, sum.z()} : vec3(sum);
  }
  dynamics.add_friction(change);
}

double FrictionFollower::error(int hinge) const {
  const Hinge& h = hinges_[hinge];
  double largest = 0;
  for (int k = h.first; k < h.first + h.count; ++k) {
    largest = std::max(largest, joints_.error(k));
  }
  return largest;
}

}  // namespace multibody
