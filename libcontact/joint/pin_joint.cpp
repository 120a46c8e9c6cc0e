#include "libcontact/joint/pin_joint.hpp"

#include <cmath>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/joint/solver.hpp"

namespace contact {
namespace {

using Eigen::Vector3d;

Vector3d across(const Vector3d& force, const Vector3d& axis) {
  return force - force.dot(axis) * axis;
}

}  // namespace

PinJoint::PinJoint(JointContact contact) : contact_(std::move(contact)) {
  if (contact_.geometry().kind() != JointKind::pin) {
    throw Error(detail::must_be("pin joint: geometry of a ball joint",
                                "of a pin joint"));
  }
}

JointSolution PinJoint::solve(const Vector3d& reaction, const Vector3d& axis,
                              double rate,
                              const SolveOptions& options) const noexcept {
  return detail::solve_reaction(contact_, across(reaction, axis), rate * axis,
                                nullptr, options);
}

JointSolution PinJoint::solve(const Vector3d& reaction, const Vector3d& axis,
                              double rate, const JointSolution& last,
                              const SolveOptions& options) const noexcept {
  return detail::solve_reaction(contact_, across(reaction, axis), rate * axis,
                                &last, options);
}

JointSolution PinJoint::solve_contact(const Vector3d& normal_force,
                                      const Vector3d& axis,
                                      double rate) const noexcept {
  return detail::solve_contact(contact_, across(normal_force, axis),
                               rate * axis);
}

FixedPointResult PinJoint::fixed_point(const Vector3d& reaction,
                                       const Vector3d& axis, double rate,
                                       std::span<FixedPointStep> trace,
                                       double tolerance, int step_limit,
                                       double start) const noexcept {
  return detail::fixed_point(contact_, across(reaction, axis), rate * axis,
                             trace, tolerance, step_limit, start);
}

double PinJoint::moment_limit(const Vector3d& reaction,
                              const Vector3d& axis) const noexcept {
  if (contact_.is_viscous()) return 0;
  return -solve(reaction, axis, 1).friction_moment.dot(axis);
}

double PinJoint::utilisation(const Vector3d& reaction, const Vector3d& axis,
                             double moment) const noexcept {
  return moment == 0 ? 0 : std::abs(moment) / moment_limit(reaction, axis);
}

}  // namespace contact
