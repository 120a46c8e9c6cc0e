#include "multibody/friction/hinge_solver.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/joint/derivatives.hpp"
#include "multibody/system/eigen_conversion.hpp"
#include "multibody/system/hinges/kinds.hpp"
#include "multibody/system/kinematics.hpp"

namespace multibody {
namespace {

using contact::JointSolution;
using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d nan_vector() {
  return Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
}

// Tolerance of the joints' own iteration, well below the outer loop's.
constexpr contact::SolveOptions inner{.tolerance = 1e-12};

// True if it has friction at speed 0: dry, with a coefficient above 0.
bool holds(const contact::JointContact& contact) {
  const contact::JointContact::Strength strength = contact.strength(0);
  return strength.pressure_part > 0 || strength.area_part > 0;
}

}  // namespace

HingeSolver::HingeSolver(HingeFriction friction, const Link& link, int body)
    : friction_(std::move(friction)),
      contacts_(contacts(friction_)),
      link_(link),
      axes_(link.axes),
      is_axis_(hinge_traits(link.kind).is_axis) {
  const auto refuse = [&](const char* what, const char* where) {
    throw contact::Error(contact::detail::needs(
        fmt::format("bodies[{}].friction: {}", body, what), where));
  };
  if (const auto* one = std::get_if<JointFriction>(&friction_)) {
    if (one->joint.is_pin()) {
      if (!is_axis_) refuse("a pin joint", "an axis");
    } else if (link.kind != HingeKind::ball) {
      refuse("a ball joint alone", "a ball hinge");
    }
    const contact::Joint& joint = one->joint;
    if (!joint.is_endless() && one->estimate == FrictionEstimate::traditional) {
      refuse("the traditional estimate",
             "a joint without a [seat], or "
             "without_seat");
    }
    turns_seat_ =
        !joint.is_endless() &&
        joint.contact().geometry().inner_body() == contact::JointBody::body;
  } else if (std::holds_alternative<GroupFriction>(friction_) && !is_axis_) {
    refuse("a group of joints", "an axis");
  }
  const auto* const of_group = std::get_if<GroupFriction>(&friction_);
  can_rest_ = std::ranges::any_of(contacts_, holds) ||
              (of_group && of_group->group.thrust_face() &&
               of_group->group.thrust_face()->moment(1) > 0);
}

void HingeSolver::place_seat(const double* link_state, Memory& memory) const {
  memory.placement.from_seat =
      axes_ * relative_rotation(link_, link_state).transpose();
}

HingeSolver::Memory HingeSolver::make_memory() const {
  Memory memory;
  memory.joints.resize(contacts_.size());
  if (const auto* group = std::get_if<GroupFriction>(&friction_)) {
    memory.group = group->group.make_solution();
  }
  return memory;
}

// Slip of a hinge with a single joint.
contact::Joint::Slip HingeSolver::slip_of(const Reaction<double>& reaction,
                                          const Vector3d& rate,
                                          const Memory& memory) const {
  const Vector3d axis = axes_.col(2);
  const Vector3d force = axes_ * vec3(reaction.force);
  if (is_axis_) {
    return {force - force.dot(axis) * axis, rate.z() * axis, axis};
  }
  return {.reaction = force,
          .angular_velocity = axes_ * rate,
          .placement = placement(memory)};
}

std::optional<Matrix3d> HingeSolver::slope(const Reaction<double>& reaction,
                                           const Vector3d& rate,
                                           const Memory& memory) const {
  const auto* one = std::get_if<JointFriction>(&friction_);
  if (!one || one->estimate != FrictionEstimate::consistent) return {};
  const contact::SlipDerivatives by = contact::derivatives(
      one->joint, slip_of(reaction, rate, memory), memory.joints[0]);
  if (by.status != contact::Status::ok) return {};
  return Matrix3d(axes_.transpose() * by.over_reaction * axes_);
}

Vector3d HingeSolver::slide(const Reaction<double>& reaction,
                            const Vector3d& rate, Memory& memory) const {
  const Vector3d axis = axes_.col(2);
  if (const auto* one = std::get_if<JointFriction>(&friction_)) {
    const contact::Joint::Slip slip = slip_of(reaction, rate, memory);
    JointSolution& last = memory.joints[0];
    last = one->estimate == FrictionEstimate::traditional
               ? one->joint.solve_contact(
                     {slip.reaction, slip.angular_velocity, slip.axis})
               : one->joint.solve(slip, last, inner);
    if (last.status != contact::Status::ok) return nan_vector();
    if (is_axis_) return {0, 0, last.friction_moment.dot(axis)};
    return axes_.transpose() * last.friction_moment;
  }
  if (!solve_group(reaction, rate.z(), memory)) return nan_vector();
  double sum = memory.group.thrust_moment;
  for (const JointSolution& joint : memory.joints) {
    sum += joint.friction_moment.dot(axis);
  }
  return {0, 0, sum};
}

// The joints of a group that turns.
bool HingeSolver::solve_group(const Reaction<double>& reaction, double rate,
                              Memory& memory) const {
  const auto& [group, estimate] = std::get<GroupFriction>(friction_);
  group.solve({.reaction = axes_ * vec3(reaction.force),
               .moment = axes_ * vec3(reaction.moment),
               .axis = axes_.col(2),
               .angular_velocity = rate},
              memory.group);
  std::ranges::copy(memory.group.joints, memory.joints.begin());
  // Rounding keeps lightly loaded groups from their own tolerance.
  constexpr double fair = 1e-11;
  if (memory.group.status != contact::Status::ok &&
      !(memory.group.residual <= fair)) {
    return false;
  }
  if (estimate == FrictionEstimate::traditional) {
    estimate_joints(group, rate, memory);
  }
  return true;
}

// Traditional friction of a group's joints under their forces.
void HingeSolver::estimate_joints(const contact::JointGroup& group, double rate,
                                  Memory& memory) const {
  const Vector3d axis = axes_.col(2);
  for (std::size_t k = 0; k < memory.joints.size(); ++k) {
    const Vector3d force = memory.group.joints[k].reaction;
    memory.joints[k] = group.joints()[k].joint.solve_contact(
        {.normal_force = force, .angular_velocity = rate * axis, .axis = axis});
  }
}

double HingeSolver::utilisation_of(const JointFriction& ball,
                                   const contact::Joint::Hold& hold,
                                   Memory& memory) const {
  auto& [joints, group, rest, seat, slip_direction] = memory;
  if (ball.estimate == FrictionEstimate::consistent) {
    rest = ball.joint.at_rest(hold, rest);
    joints[0] = rest.slip;
    slip_direction = axes_.transpose() * rest.direction;
    return rest.utilisation;
  }
  // n = R/|R| whatever the direction of slip.
  const Vector3d across = hold.reaction.unitOrthogonal();
  joints[0] = ball.joint.solve_contact({hold.reaction, across});
  if (joints[0].status != contact::Status::ok) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const contact::MomentSet set = ball.joint.moment_set(joints[0]);
  const double tau = set.utilisation(hold.moment);
  slip_direction.setZero();
  if (tau > 0 && std::isfinite(tau)) {
    // Normal of the boundary where the moment leaves the set.
    const Vector3d u =
        set.prox(Matrix3d::Identity(), -1.000001 / tau * hold.moment)
            .angular_velocity;
    if (!u.isZero(0)) slip_direction = axes_.transpose() * u.normalized();
  }
  return tau;
}

double HingeSolver::utilisation(const Reaction<double>& held,
                                Memory& memory) const {
  if (!is_axis_) {
    return utilisation_of(std::get<JointFriction>(friction_),
                          {.reaction = axes_ * vec3(held.force),
                           .moment = axes_ * vec3(held.moment),
                           .placement = placement(memory)},
                          memory);
  }
  const double needed = held.moment.z;
  const double sign = needed > 0 ? -1 : 1;
  memory.slip_direction = Vector3d(0, 0, needed == 0 ? 0 : sign);
  const double limit = moment_limit(held, sign, memory);
  // Without body too 0 is held.
  return needed == 0 ? 0 * limit : std::abs(needed) / limit;
}

// Moment that the joints on an axis hold against sliding with this sign.
double HingeSolver::moment_limit(const Reaction<double>& held, double sign,
                                 Memory& memory) const {
  const auto* group = std::get_if<GroupFriction>(&friction_);
  if (!group) return std::abs(slide(held, Vector3d(0, 0, sign), memory).z());
  if (!solve_group(held, sign, memory)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  double limit = std::abs(memory.group.thrust_moment);
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    if (!holds(contacts_[k])) continue;
    limit += std::abs(memory.joints[k].friction_moment.dot(axes_.col(2)));
  }
  return limit;
}

int HingeSolver::failed_joint(const Memory& memory) {
  const auto failed =
      std::ranges::find_if(memory.joints, [](const JointSolution& joint) {
        return joint.status != contact::Status::ok;
      });
  return failed == memory.joints.end()
             ? 0
             : static_cast<int>(failed - memory.joints.begin());
}

Vector3d HingeSolver::prox(const Matrix3d& inertia, const Vector3d& free,
                           const Memory& memory) const {
  const contact::Joint& joint = std::get<JointFriction>(friction_).joint;
  const Matrix3d given = axes_ * inertia * axes_.transpose();
  return axes_.transpose() * joint.moment_set(memory.joints[0])
                                 .prox(given, axes_ * free)
                                 .angular_velocity;
}

}  // namespace multibody
