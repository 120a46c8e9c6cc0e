#include "multibody/friction/friction_tracker.hpp"

#include <algorithm>

namespace multibody {
namespace {

using contact::JointContact;
using contact::VectorRows;
using Eigen::Vector3d;

// Numbers of hinges side by side.
using Lanes = Eigen::Array<double, 4, 1>;

// A component of the vectors of rows.
Eigen::Map<Lanes> at(double* row, int component = 0) {
  return Eigen::Map<Lanes>(row + component * VectorRows::lanes);
}
Eigen::Map<const Lanes> at(const double* row, int component = 0) {
  return Eigen::Map<const Lanes>(row + component * VectorRows::lanes);
}

// Contacts of a hinge that can be tracked; empty for thrust faces and seats.
std::vector<JointContact> contacts_of(const HingeFriction& friction) {
  const auto* const of_group = std::get_if<GroupFriction>(&friction);
  if (of_group && of_group->group.thrust_face()) return {};
  const auto* const alone = std::get_if<JointFriction>(&friction);
  if (alone && !alone->joint.is_endless()) return {};
  const auto is_consistent = [](const auto& of) {
    if constexpr (requires { of.estimate; }) {
      return of.estimate == FrictionEstimate::consistent;
    }
    return false;
  };
  return std::visit(is_consistent, friction) ? contacts(friction)
                                             : std::vector<JointContact>();
}

}  // namespace

FrictionTracker::FrictionTracker(const std::vector<HingeFriction>& friction)
    : joints_(lay_out(friction)),
      across_(row_),
      rows_((row_ + VectorRows::lanes - 1) / VectorRows::lanes) {
  for (auto* share : {&shares_.force, &shares_.moment, &shares_.axial}) {
    share->resize(joints_.size());
  }
  for (std::size_t i = 0; i < friction.size(); ++i) {
    set_shares(static_cast<int>(i), friction[i]);
  }
}

std::vector<JointContact> FrictionTracker::lay_out(
    const std::vector<HingeFriction>& friction) {
  std::vector<std::vector<JointContact>> all;
  for (const HingeFriction& f : friction) {
    all.push_back(contacts_of(f));
    const auto* const alone = std::get_if<JointFriction>(&f);
    const int count = static_cast<int>(all.back().size());
    hinges_.push_back({count, !alone || alone->joint.is_pin()});
    depth_ = std::max(depth_, count);
    is_direct_ = is_direct_ && alone && count == 1;
  }
  if (depth_ == 0) return {};
  const int size = static_cast<int>(friction.size());
  constexpr int lanes = Lanes::SizeAtCompileTime;
  row_ = (size + lanes - 1) / lanes * lanes;
  const auto any =
      std::ranges::find_if(all, [](auto& c) { return !c.empty(); });
  std::vector<JointContact> joints(depth_ * row_, any->front());
  for (int i = 0; i < size; ++i) {
    for (int k = 0; k < hinges_[i].joints; ++k) joints[joint(i, k)] = all[i][k];
  }
  return joints;
}

void FrictionTracker::set_shares(int hinge, const HingeFriction& friction) {
  const auto [count, is_axis] = hinges_[hinge];
  if (count > 0) across_[hinge] = is_axis ? 0 : 1;
  const auto* const of_group = std::get_if<GroupFriction>(&friction);
  for (int k = 0; k < count; ++k) {
    const contact::JointGroup::Share share =
        of_group ? of_group->group.shares()[k]
                 : contact::JointGroup::Share{1, 0, is_axis ? 0.0 : 1.0};
    shares_.force[joint(hinge, k)] = share.force;
    shares_.moment[joint(hinge, k)] = share.moment;
    shares_.axial[joint(hinge, k)] = share.axial;
  }
}

void FrictionTracker::start(int hinge, const HingeSolver& solver,
                            const HingeSolver::Memory& last,
                            const Vector3d& rate) {
  stop(hinge);
  for (int k = 0; k < hinges_[hinge].joints; ++k) {
    const int i = joint(hinge, k);
    joints_.start(i, last.joints[k], rate);
    joints_.set_applied_moment(i, solver.joint_moment(k, last));
  }
  count_ += is_tracked(hinge);
}

void FrictionTracker::stop(int hinge) {
  count_ -= is_tracked(hinge);
  for (int k = 0; k < hinges_[hinge].joints; ++k) joints_.stop(joint(hinge, k));
}

bool FrictionTracker::all(int hinge,
                          bool (JointTracker::*of)(int) const noexcept) const {
  const int count = hinges_[hinge].joints;
  int k = 0;
  while (k < count && (joints_.*of)(joint(hinge, k))) ++k;
  return count > 0 && k == count;
}

// Only the sum of a group's moments along the axis is known: the first joint
// takes the change.
void FrictionTracker::set_applied_moment(int hinge, const Vector3d& moment) {
  const int first = joint(hinge, 0);
  joints_.set_applied_moment(
      first, moment - (applied_moment(hinge) - joints_.applied_moment(first)));
}

void FrictionTracker::take_reactions(const Dynamics& dynamics) {
  if (is_direct_) {
    dynamics.reactions(joints_.reactions(), nullptr);
    return;
  }
  const VectorRows moments = rows(&HingeRows::moment);
  dynamics.reactions(rows(&HingeRows::force), &moments);
  share_reactions();
}

void FrictionTracker::share_reactions() {
  const VectorRows applied = joints_.applied_moments();
  const VectorRows reactions = joints_.reactions();
  for (int i = 0; i < row_; i += Lanes::SizeAtCompileTime) {
    const double* const f = rows(&HingeRows::force).at(i);
    const double* const m = rows(&HingeRows::moment).at(i);
    // Friction moments across the axis load a group too.
    Lanes held_x = at(m, 1);
    Lanes held_y = -at(m, 0);
    for (int k = 0; k < depth_; ++k) {
      const double* const a = applied.at(joint(i, k));
      held_x -= at(a, 1);
      held_y += at(a, 0);
    }
    for (int k = 0; k < depth_; ++k) {
      const int first = joint(i, k);
      const Lanes force = at(&shares_.force[first]);
      const Lanes moment = at(&shares_.moment[first]);
      double* const r = reactions.at(first);
      at(r, 0) = force * at(f, 0) + moment * held_x;
      at(r, 1) = force * at(f, 1) + moment * held_y;
      at(r, 2) = at(&shares_.axial[first]) * at(f, 2);
    }
  }
}

void FrictionTracker::move(Dynamics& dynamics) {
  const VectorRows steps = joints_.steps();
  if (is_direct_) return dynamics.add_friction(steps);
  const VectorRows change = rows(&HingeRows::change);
  for (int i = 0; i < row_; i += Lanes::SizeAtCompileTime) {
    for (int c = 0; c < 3; ++c) {
      Lanes sum = at(steps.at(i), c);
      for (int k = 1; k < depth_; ++k) sum += at(steps.at(joint(i, k)), c);
      at(change.at(i), c) = c == 2 ? sum : Lanes(at(&across_[i]) * sum);
    }
  }
  dynamics.add_friction(change);
}

}  // namespace multibody
