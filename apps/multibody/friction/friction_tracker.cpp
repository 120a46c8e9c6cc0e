#include "multibody/friction/friction_tracker.hpp"

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

// Of a hinge that can be tracked.
std::vector<JointContact> contacts_of(const HingeFriction& friction) {
  const auto is_consistent = [](const auto& of) {
    if constexpr (requires { of.estimate; }) {
      return of.estimate == FrictionEstimate::consistent;
    }
    return false;
  };
  return std::visit(is_consistent, friction) ? contacts(friction)
                                             : std::vector<JointContact>();
}

std::vector<JointContact> all_contacts(
    const std::vector<HingeFriction>& friction) {
  std::vector<JointContact> all;
  for (const HingeFriction& f : friction) {
    std::ranges::move(contacts_of(f), std::back_inserter(all));
  }
  return all;
}

}  // namespace

FrictionTracker::FrictionTracker(const std::vector<HingeFriction>& friction)
    : joints_(all_contacts(friction)) {
  for (const HingeFriction& f : friction) add(f);
}

void FrictionTracker::add(const HingeFriction& friction) {
  const std::size_t first = shares_.size();
  const std::size_t count = contacts_of(friction).size();
  const auto* const alone = std::get_if<JointFriction>(&friction);
  const bool is_axis = !alone || alone->joint.is_pin();
  hinges_.push_back(
      {static_cast<int>(first), static_cast<int>(first + count), is_axis});
  shares_.resize(first + count, {1, 0, is_axis ? 0.0 : 1.0});
  const auto* const of_group = std::get_if<GroupFriction>(&friction);
  is_direct_ = is_direct_ && !of_group && count == 1;
  if (!of_group || count == 0) return;
  std::ranges::copy(of_group->group.shares(), shares_.begin() + first);
}

void FrictionTracker::start(int hinge, const HingeSolver& solver,
                            const HingeSolver::Memory& last,
                            const Vector3d& rate) {
  stop(hinge);
  const auto [first, end, is_axis] = hinges_[hinge];
  for (int k = first; k < end; ++k) {
    joints_.start(k, last.joints[k - first], rate);
    joints_.set_applied_moment(k, solver.joint_moment(k - first, last));
  }
  count_ += is_tracked(hinge);
}

void FrictionTracker::stop(int hinge) {
  count_ -= is_tracked(hinge);
  const auto [first, end, is_axis] = hinges_[hinge];
  for (int k = first; k < end; ++k) joints_.stop(k);
}

bool FrictionTracker::is_tracked(int hinge) const {
  const auto [first, end, is_axis] = hinges_[hinge];
  int k = first;
  while (k < end && joints_.is_tracked(k)) ++k;
  return first < end && k == end;
}

// Of a group only the sum of the joints' moments along the axis is known: the
// first joint takes what it has changed by.
void FrictionTracker::set_applied_moment(int hinge, const Vector3d& moment) {
  const int first = hinges_[hinge].first;
  joints_.set_applied_moment(
      first, moment - (applied_moment(hinge) - joints_.applied_moment(first)));
}

void FrictionTracker::take_reactions(const Dynamics& dynamics,
                                     std::span<const int> hinges,
                                     std::span<Reaction<double>> reactions) {
  if (is_direct_) {
    dynamics.forces(joints_.reactions());
    return;
  }
  dynamics.reactions(reactions);
  for (const int i : hinges) set_reactions(hinges_[i], reactions[i]);
}

void FrictionTracker::set_reactions(const Hinge& hinge,
                                    const Reaction<double>& reaction) {
  const auto& [force, moment] = reaction;
  // Moments of friction across the axis load a group as well.
  double held_x = moment.y;
  double held_y = -moment.x;
  for (int k = hinge.first; k < hinge.end; ++k) {
    const Vector3d applied = joints_.applied_moment(k);
    held_x -= applied.y();
    held_y += applied.x();
  }
  for (int k = hinge.first; k < hinge.end; ++k) {
    const contact::JointGroup::Share& share = shares_[k];
    joints_.set_reaction(k, {share.force * force.x + share.moment * held_x,
                             share.force * force.y + share.moment * held_y,
                             share.axial * force.z});
  }
}

void FrictionTracker::move(Dynamics& dynamics, std::span<const int> hinges,
                           std::span<Vec3<double>> change) {
  if (is_direct_) {
    dynamics.add_friction(joints_.steps());
    return;
  }
  for (const int i : hinges) {
    change[i] = vec3(sum(i, [&](int k) { return joints_.step(k); }));
  }
  dynamics.add_friction(change);
}

}  // namespace multibody
