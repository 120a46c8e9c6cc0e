#include "libcontact/joint/fixed_point.hpp"

#include <algorithm>
#include <cmath>

#include "libcontact/base/magnitude.hpp"
#include "libcontact/joint/slip/taken_force.hpp"

namespace contact {

FixedPointResult fixed_point(const Joint& joint, const Joint::Slip& slip,
                             std::span<FixedPointStep> trace,
                             const FixedPointOptions& options) noexcept {
  const JointContact& contact = joint.contact();
  const Eigen::Vector3d& rate = slip.angular_velocity;
  const Eigen::Vector3d reaction =
      detail::taken(joint, slip.reaction, rate, slip.axis);
  const double force = magnitude(reaction);
  const double speed = magnitude(rate);
  // Parallel vectors may round to more than 1.
  const double cos_b =
      std::clamp((reaction / force).dot(rate / speed), -1.0, 1.0);
  const JointContact::Strength strength = contact.strength(speed);
  FixedPointResult result = {Status::not_converged, 0, 0};
  if (!joint.is_endless()) {
    result.status = Status::out_of_range;
    return result;
  }
  double f = options.start;  // 0: g_1 = 0 (4.3)
  while (result.steps < options.step_limit) {
    const double g = std::atan(f);
    const double cos_g = 1 / std::hypot(1, f);
    const double sin_a = cos_b / cos_g;  // (4.2)
    if (!(std::abs(sin_a) <= 1)) {
      result.status = Status::out_of_range;
      break;
    }
    const SlipAxis axis = {sin_a, std::sqrt((1 - sin_a) * (1 + sin_a))};
    const double normal_force = force * cos_g;  // (4.1)
    const double half_angle = contact.half_angle(normal_force).half_angle;
    const FrictionIntegrals i =
        contact.integrals(half_angle, axis, {normal_force, speed});
    const double next = strength.pressure_part * i.coefficient.force +
                        strength.area_part / normal_force * i.area.force;
    if (static_cast<std::size_t>(result.steps) < trace.size()) {
      trace[result.steps] = {
          result.steps + 1,
          g,
          std::atan2(axis.sin, axis.cos),
          normal_force,
          strength.area_part / (strength.pressure_part * normal_force),
          contact.load_parameter(normal_force),
          half_angle,
          next};
    }
    ++result.steps;
    result.residual = next == f ? 0 : std::abs(next / f - 1);
    if (result.residual <= options.tolerance) {
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
