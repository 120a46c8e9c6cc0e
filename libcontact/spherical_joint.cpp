#include "libcontact/spherical_joint.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "libcontact/detail/joint_solver.hpp"
#include "libcontact/error.hpp"

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
                                             double tolerance,
                                             int step_limit) const noexcept {
  const double force = reaction.stableNorm();
  const double speed = rate.stableNorm();
  const double cos_b = (reaction / force).dot(rate / speed);
  const JointContact::Strength strength = contact_.strength(speed);
  FixedPointResult result = {Status::not_converged, 0, 0};
  double f = 0;  // g_1 = 0 (4.3)
  while (result.steps < step_limit) {
    const double g = std::atan(f);
    const double cos_g = 1 / std::hypot(1, f);
    const double sin_a = cos_b / cos_g;  // (4.2)
    if (!(std::abs(sin_a) <= 1)) {
      result.status = Status::out_of_range;
      break;
    }
    const SlipAxis axis = {sin_a, std::sqrt((1 - sin_a) * (1 + sin_a))};
    const double compressive_force = force * cos_g;  // (4.1)
    const double half_angle = contact_.half_angle(compressive_force).half_angle;
    const FrictionIntegrals i = contact_.integrals(half_angle, axis);
    const double next = strength.pressure_part * i.coefficient.force +
                        strength.area_part / compressive_force * i.area.force;
    if (static_cast<std::size_t>(result.steps) < trace.size()) {
      trace[result.steps] = {
          result.steps + 1,
          g,
          std::atan2(axis.sin, axis.cos),
          compressive_force,
          strength.area_part / (strength.pressure_part * compressive_force),
          contact_.load_parameter(compressive_force),
          half_angle,
          next};
    }
    ++result.steps;
    result.residual = next == f ? 0 : std::abs(next / f - 1);
    if (result.residual <= tolerance) {
      result.status = Status::ok;
      break;
    }
    if (std::isnan(next)) {
      result.status = Status::out_of_range;
      break;
    }
    f = next;
  }
  return result;
}

}  // namespace contact
