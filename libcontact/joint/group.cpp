#include "libcontact/joint/group.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "libcontact/base/check.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace contact {
namespace {

using Eigen::Vector3d;
using Member = JointGroup::Member;
using Sharing = JointGroup::Sharing;

constexpr const char* place = "joint group";

bool is_ball(const Member& joint) { return !joint.joint.is_pin(); }

int count_balls(const std::vector<Member>& joints) {
  return static_cast<int>(std::ranges::count_if(joints, is_ball));
}

void check_joints(const std::vector<Member>& joints, bool has_face) {
  if (joints.size() < 2) {
    throw Error(
        detail::needs(detail::message("{} of {} joint", place, joints.size()),
                      "at least 2, to hold moments across the axis"));
  }
  for (const Member& one : joints) {
    if (one.joint.is_endless()) continue;
    throw Error(detail::needs(
        place, one.joint.is_pin() ? "pins without a [relief], or without_relief"
                                  : "balls without a [seat], or without_seat"));
  }
  if (count_balls(joints) == 0 && !has_face) {
    throw Error(detail::needs(
        place,
        "a ball joint or a thrust_face, to take the force along the axis"));
  }
  if (count_balls(joints) > 0 && has_face) {
    throw Error(detail::needs(
        detail::message("{} with a thrust face", place),
        "pins alone: how a ball shares the force along the axis is not known"));
  }
  std::vector<double> positions;
  for (const Member& joint : joints) {
    detail::require(std::isfinite(joint.position), place, "position",
                    joint.position, "finite");
    positions.push_back(joint.position);
  }
  std::ranges::sort(positions);
  const auto twin = std::ranges::adjacent_find(positions);
  if (twin != positions.end()) {
    throw Error(detail::message(
        "{}: {}", place,
        detail::duplicate("position", detail::message("{} m", *twin))));
  }
}

void check_rule(const Sharing& rule, const std::vector<Member>& joints,
                bool has_face) {
  if (rule.radial_stiffness.size() != joints.size() ||
      rule.axial_share.size() != joints.size()) {
    throw Error(detail::needs(
        detail::message("{}: sharing rule for {} and {} joints", place,
                        rule.radial_stiffness.size(), rule.axial_share.size()),
        detail::message("one value for each of the {} joints", joints.size())));
  }
  double sum = 0;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const double stiffness = rule.radial_stiffness[i];
    const double share = rule.axial_share[i];
    detail::require(detail::is_above_zero(stiffness), place, "radial_stiffness",
                    stiffness, "above 0 and finite");
    detail::require(is_ball(joints[i]) ? share >= 0 : share == 0, place,
                    "axial_share", share,
                    is_ball(joints[i]) ? "0 or above" : "0 for a pin");
    sum += share;
  }
  // Decimal shares such as 0.1 + 0.2 + 0.7.
  const double whole = has_face ? 0 : 1;
  detail::require(std::abs(sum - whole) < 1e-12, place, "sum of axial_share",
                  sum, has_face ? "0 beside a thrust face" : "1");
}

// The rule that statics gives.
Sharing determinate_rule(const std::vector<Member>& joints) {
  if (joints.size() > 2) {
    throw Error(detail::needs(
        detail::message("{} of {} joints", place, joints.size()),
        "a sharing rule: more than 2 share the force across the axis, "
        "statically indeterminate"));
  }
  if (count_balls(joints) > 1) {
    throw Error(detail::needs(
        detail::message("{} of {} ball joints", place, count_balls(joints)),
        "a sharing rule: more than 1 shares the force along the axis, "
        "statically indeterminate"));
  }
  return Sharing::equal(joints);
}

// The part of v normal to the unit vector u.
Vector3d across(const Vector3d& v, const Vector3d& u) {
  return v - v.dot(u) * u;
}

}  // namespace

JointGroup::Sharing JointGroup::Sharing::equal(
    const std::vector<Member>& joints) {
  Sharing rule;
  const int balls = count_balls(joints);
  for (const Member& joint : joints) {
    rule.radial_stiffness.push_back(1);
    rule.axial_share.push_back(is_ball(joint) ? 1.0 / balls : 0.0);
  }
  return rule;
}

JointGroup::JointGroup(std::vector<Member> joints, std::optional<Sharing> rule,
                       std::optional<ThrustFace> thrust_face)
    : joints_(std::move(joints)), thrust_face_(std::move(thrust_face)) {
  check_joints(joints_, thrust_face_.has_value());
  if (!rule) rule = determinate_rule(joints_);
  check_rule(*rule, joints_, thrust_face_.has_value());
  // Springs k_j under a rigid axis that shifts and tilts: R_j = k_j (shift +
  // z_j tilt), about the springs' centre, where the two do not mix.
  const std::vector<double>& k = rule->radial_stiffness;
  double sum = 0;
  double first = 0;
  for (std::size_t i = 0; i < k.size(); ++i) {
    sum += k[i];
    first += k[i] * joints_[i].position;
  }
  const double centre = first / sum;
  double second = 0;
  for (std::size_t i = 0; i < k.size(); ++i) {
    const double arm = joints_[i].position - centre;
    second += k[i] * arm * arm;
  }
  for (std::size_t i = 0; i < k.size(); ++i) {
    const double tilt = k[i] * (joints_[i].position - centre) / second;
    shares_.push_back({k[i] / sum - tilt * centre, tilt, rule->axial_share[i]});
  }
}

JointGroup::Solution JointGroup::make_solution() const {
  Solution solution;
  solution.joints.resize(joints_.size());
  return solution;
}

void JointGroup::solve(const Slip& slip, Solution& solution) const noexcept {
  const auto& [reaction, moment, axis, angular_velocity] = slip;
  // Friction moments count little in the balance (rho/distance), so a few
  // rounds do; more only where joints are closer than their radii.
  constexpr int round_limit = 100;
  constexpr double tolerance = 1e-14;
  const double axial = reaction.dot(axis);
  const Vector3d radial = across(reaction, axis);
  const Vector3d turned = moment.cross(axis);  // sum z_j R_j
  Solution& s = solution;
  if (s.status != Status::ok) s.cross_moment.setZero();
  s.status = Status::not_converged;
  for (s.iterations = 1; s.iterations <= round_limit; ++s.iterations) {
    const Vector3d held = turned - s.cross_moment.cross(axis);
    double change = 0;
    double largest = 0;
    s.thrust_moment =
        thrust_face_ && angular_velocity != 0
            ? -std::copysign(thrust_face_->moment(axial), angular_velocity)
            : 0;
    s.friction_moment = s.thrust_moment;
    s.power = s.thrust_moment * angular_velocity;
    s.cross_moment.setZero();
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      JointSolution& joint = s.joints[i];
      const Share& share = shares_[i];
      const Vector3d force = share.force * radial + share.moment * held;
      change = std::max(change, (force - across(joint.reaction, axis)).norm());
      largest = std::max(largest, force.norm());
      joint = joints_[i].joint.solve(
          {.reaction = force + share.axial * axial * axis,
           .angular_velocity = angular_velocity * axis,
           .axis = axis},
          joint);
      s.friction_moment += joint.friction_moment.dot(axis);
      s.cross_moment += across(joint.friction_moment, axis);
      s.power += joint.power;
      if (joint.status != Status::ok) {
        s.status = joint.status;
        s.residual = joint.residual;
        return;
      }
    }
    s.residual = largest > 0 ? change / largest : 0;
    // The first round compares with another reaction.
    if (s.iterations > 1 && s.residual <= tolerance) {
      s.status = Status::ok;
      return;
    }
  }
}

double JointGroup::utilisation(const Hold& hold,
                               Solution& solution) const noexcept {
  const auto& [reaction, moment, axis, needed] = hold;
  // Sliding that friction would oppose with the moment that is needed.
  solve({reaction, moment, axis, needed > 0 ? -1.0 : 1.0}, solution);
  if (needed == 0) return 0;
  double held = std::abs(solution.thrust_moment);
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (joints_[i].joint.contact().is_viscous()) continue;
    if (joints_[i].joint.contact().stress()) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    held += std::abs(solution.joints[i].friction_moment.dot(axis));
  }
  return std::abs(needed) / held;
}

}  // namespace contact
