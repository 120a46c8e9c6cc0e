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
      hinge.is_node = has_nodes_ = true;
      set_shares(node->node, first);
    }
    first += hinge.count;
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
  }
}

void FrictionFollower::start(int hinge, const HingeSolver& solver,
                             const Vector3d& rate) {
  Hinge& h = hinges_[hinge];
  for (int k = 0; k < h.count; ++k) {
    joints_.start(h.first + k, solver.joints()[k], rate);
  }
  const Vector3d cross = solver.cross_moment();
  h.cross_x = cross.x();
  h.cross_y = cross.y();
}

void FrictionFollower::forget(int hinge) {
  const Hinge& h = hinges_[hinge];
  for (int k = 0; k < h.count; ++k) joints_.forget(h.first + k);
}

bool FrictionFollower::follows(int hinge) const {
  const Hinge& h = hinges_[hinge];
  for (int k = 0; k < h.count; ++k) {
    if (!joints_.follows(h.first + k)) return false;
  }
  return h.count > 0;
}

void FrictionFollower::set_rate(int hinge, const Vector3d& rate) {
  const Hinge& h = hinges_[hinge];
  for (int k = h.first; k < h.first + h.count; ++k) joints_.set_rate(k, rate);
}

void FrictionFollower::set_reactions(std::span<const int> hinges,
                                     Reactions reactions) {
  for (const int i : hinges) {
    const Hinge& h = hinges_[i];
    const auto& [force, moment] = reactions[i];
    if (!h.is_node) {
      joints_.set_reaction(h.first,
                           Vector3d(force.x, force.y, h.is_axis ? 0 : force.z));
      continue;
    }
    const double held_x = moment.y - h.cross_y;
    const double held_y = h.cross_x - moment.x;
    for (int k = h.first; k < h.first + h.count; ++k) {
      const Shares& share = shares_[k];
      joints_.set_reaction(
          k, Vector3d(share.radial * force.x + share.moment * held_x,
                      share.radial * force.y + share.moment * held_y,
                      share.axial * force.z));
    }
  }
}

// @return how much they changed, relative
double FrictionFollower::take_cross_moments(std::span<const int> hinges) {
  double largest = 0;
  for (const int i : hinges) {
    Hinge& h = hinges_[i];
    if (!h.is_node) continue;
    double x = 0;
    double y = 0;
    double size = 0;
    for (int k = h.first; k < h.first + h.count; ++k) {
      const Vector3d moment = joints_.moment(k);
      x += moment.x();
      y += moment.y();
      size += moment.squaredNorm();
    }
    const double change =
        (x - h.cross_x) * (x - h.cross_x) + (y - h.cross_y) * (y - h.cross_y);
    if (change > largest * size) largest = change / size;
    h.cross_x = x;
    h.cross_y = y;
  }
  return std::sqrt(largest);
}

// Moments go with forces, and forces with cross moments, a little.
void FrictionFollower::settle_nodes(std::span<const int> hinges,
                                    Reactions reactions) {
  if (!has_nodes_) return;
  constexpr int round_limit = 4;
  constexpr double tolerance = 1e-11;
  for (int round = 0; round < round_limit; ++round) {
    if (take_cross_moments(hinges) <= tolerance) return;
    set_reactions(hinges, reactions);
    joints_.extend();
  }
}

void FrictionFollower::predict(std::span<const int> hinges,
                               Reactions reactions) {
  set_reactions(hinges, reactions);
  joints_.predict();
  settle_nodes(hinges, reactions);
}

void FrictionFollower::extend(std::span<const int> hinges,
                              Reactions reactions) {
  set_reactions(hinges, reactions);
  joints_.extend();
  settle_nodes(hinges, reactions);
}

void FrictionFollower::evaluate(std::span<const int> hinges,
                                Reactions reactions) {
  set_reactions(hinges, reactions);
  joints_.evaluate();
  settle_nodes(hinges, reactions);
}

bool FrictionFollower::tracks(int hinge) const {
  const Hinge& h = hinges_[hinge];
  for (int k = h.first; k < h.first + h.count; ++k) {
    if (!joints_.tracks(k)) return false;
  }
  return true;
}

double FrictionFollower::shift(int hinge) const {
  const Hinge& h = hinges_[hinge];
  double largest = 0;
  for (int k = h.first; k < h.first + h.count; ++k) {
    largest = std::max(largest, joints_.shift(k));
  }
  return largest;
}

Vector3d FrictionFollower::moment(int hinge) const {
  const Hinge& h = hinges_[hinge];
  if (!h.is_axis) return joints_.moment(h.first);
  double sum = 0;
  for (int k = h.first; k < h.first + h.count; ++k) {
    sum += joints_.moment(k).z();
  }
  return {0, 0, sum};
}

double FrictionFollower::error(int hinge) const {
  const Hinge& h = hinges_[hinge];
  if (!h.is_node) return joints_.error(h.first);
  double sum = 0;
  double whole = 0;
  for (int k = h.first; k < h.first + h.count; ++k) {
    const Vector3d moment = joints_.moment(k);
    sum += joints_.error(k) * moment.norm();
    whole += std::abs(moment.z());
  }
  return sum / whole;
}

}  // namespace multibody
