#include "libcontact/joint/ball_joint.hpp"

#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/joint/solver.hpp"

namespace contact {

using Eigen::Vector3d;

BallJoint::BallJoint(JointContact contact) : contact_(std::move(contact)) {
  if (contact_.geometry().kind() != JointKind::ball) {
    throw Error(detail::must_be("ball joint: geometry of a pin joint",
                                "of a ball joint"));
  }
}

JointSolution BallJoint::solve(const Vector3d& reaction, const Vector3d& rate,
                               const SolveOptions& options) const noexcept {
  return detail::solve_reaction(contact_, reaction, rate, nullptr, options);
}

JointSolution BallJoint::solve(const Vector3d& reaction, const Vector3d& rate,
                               const JointSolution& last,
                               const SolveOptions& options) const noexcept {
  return detail::solve_reaction(contact_, reaction, rate, &last, options);
}

JointSolution BallJoint::solve_contact(const Vector3d& normal_force,
                                       const Vector3d& rate) const noexcept {
  return detail::solve_contact(contact_, normal_force, rate);
}

FixedPointResult BallJoint::fixed_point(const Vector3d& reaction,
                                        const Vector3d& rate,
                                        std::span<FixedPointStep> trace,
                                        double tolerance, int step_limit,
                                        double start) const noexcept {
  return detail::fixed_point(contact_, reaction, rate, trace, tolerance,
                             step_limit, start);
}

}  // namespace contact
