#include "libcontact/joint/spherical_joint.hpp"

#include <utility>

#include "libcontact/base/error.hpp"
#include "libcontact/joint/solver.hpp"

namespace contact {

using Eigen::Vector3d;

SphericalJoint::SphericalJoint(JointContact contact)
    : contact_(std::move(contact)) {
  if (contact_.geometry().kind() != JointKind::spherical) {
    throw Error("spherical joint: geometry of a cylindrical joint");
  }
}

JointSolution SphericalJoint::solve(
    const Vector3d& reaction, const Vector3d& rate,
    const SolveOptions& options) const noexcept {
  return detail::solve_reaction(contact_, reaction, rate, nullptr, options);
}

JointSolution SphericalJoint::solve(
    const Vector3d& reaction, const Vector3d& rate, const JointSolution& last,
    const SolveOptions& options) const noexcept {
  return detail::solve_reaction(contact_, reaction, rate, &last, options);
}

JointSolution SphericalJoint::solve_contact(
    const Vector3d& compressive_force, const Vector3d& rate) const noexcept {
  return detail::solve_contact(contact_, compressive_force, rate);
}

FixedPointResult SphericalJoint::fixed_point(const Vector3d& reaction,
                                             const Vector3d& rate,
                                             std::span<FixedPointStep> trace,
                                             double tolerance, int step_limit,
                                             double start) const noexcept {
  return detail::fixed_point(contact_, reaction, rate, trace, tolerance,
                             step_limit, start);
}

}  // namespace contact
