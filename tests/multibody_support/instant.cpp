#include "multibody_support/instant.hpp"

#include <Eigen/Geometry>

#include "multibody/system/eigen_conversion.hpp"
#include "multibody_support/prepared.hpp"

namespace multibody {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

void put_vector(const Vector3d& v, double* to) {
  for (int i = 0; i < 3; ++i) to[i] = v[i];
}
void put_rotation(const Matrix3d& rotation, double* to) {
  const Eigen::Quaterniond q(rotation);
  to[0] = q.w();
  to[1] = q.x();
  to[2] = q.y();
  to[3] = q.z();
}

// The carrier's numbers, and a released load's.
void put_body(const Vector3d& position, const Vector3d& velocity,
              const Matrix3d& rotation, const Vector3d& angular_velocity,
              double* to) {
  put_vector(position, to + StateLayout::position);
  put_vector(velocity, to + StateLayout::velocity);
  put_rotation(rotation, to + StateLayout::rotation);
  put_vector(angular_velocity, to + StateLayout::angular_velocity);
}

// C and the relative angular velocity, given axes.
Matrix3d relative_rotation(const LoadInstant& load) {
  return load.load.kind == JointKind::axis
             ? axis_rotation(load.load, load.angle)
             : load.rotation;
}
Vector3d relative_velocity(const LoadInstant& load) {
  return load.load.kind == JointKind::axis
             ? Vector3d(load.angle_rate * load.load.hinge_to_load.col(2))
             : load.relative_angular_velocity;
}

void put_load(const Instant& instant, const LoadInstant& load, const Link& link,
              double* to) {
  const Matrix3d rotation = relative_rotation(load) * link.axes;
  const Vector3d relative = link.axes.transpose() * relative_velocity(load);
  if (load.mode == JointMode::released) {
    const Vector3d w =
        relative + rotation.transpose() * instant.angular_velocity;
    put_body(Vector3d::Zero(), Vector3d::Zero(), instant.rotation * rotation, w,
             to);
  } else if (link.kind == JointKind::axis) {
    to[0] = load.angle;
    to[1] = load.angle_rate;
  } else {
    put_rotation(rotation, to);
    put_vector(relative, to + 4);
  }
}

Matrix3d friction_axes(const Link& link) {
  return link.kind == JointKind::axis ? link.axes_to_hinge : link.axes;
}

LoadResult load_result(const LoadInstant& load, const Link& link,
                       const Dynamics& dynamics,
                       const Reaction<double>& reaction, int i) {
  const Matrix3d& axes = link.axes;
  const Vector3d relative = vec3(dynamics.relative_acceleration(i));
  LoadResult result;
  result.angular_acceleration = axes * vec3(dynamics.angular_acceleration(i));
  result.relative_angular_acceleration = load.mode == JointMode::released
                                             ? Vector3d::Zero()
                                             : Vector3d(axes * relative);
  result.angle_acceleration = relative.z();
  result.reaction_force = axes * vec3(reaction.force);
  result.reaction_moment = axes * vec3(reaction.moment);
  result.reaction_moment_hinge = friction_axes(link) * vec3(reaction.moment);
  result.acceleration = (load.active_force + result.reaction_force) / link.mass;
  return result;
}

}  // namespace

Matrix3d axis_rotation(const Load& load, double angle) {
  const Eigen::AngleAxisd turn(angle, Vector3d::UnitZ());
  return load.hinge_to_carrier_zero * turn.toRotationMatrix() *
         load.hinge_to_load.transpose();
}

Dynamics Prepared::dynamics() const {
  Dynamics result(system);
  for (int i = 0; i < result.size(); ++i) result.set_mode(i, modes[i]);
  return result;
}

Prepared prepare(const Instant& instant) {
  std::vector<Load> loads;
  std::vector<JointMode> modes;
  for (const LoadInstant& load : instant.loads) {
    loads.push_back(load.load);
    modes.push_back(load.mode);
  }
  Prepared p{System(instant.carrier, loads), std::move(modes), {}, {}};
  const StateLayout layout(p.system, p.modes);
  p.state.resize(layout.size());
  put_body(instant.position, instant.velocity, instant.rotation,
           instant.angular_velocity, p.state.data());
  p.loading.carrier.force = vec3(instant.active_force);
  p.loading.carrier.moment = vec3(instant.active_moment_com);
  for (int i = 0; i < p.system.size(); ++i) {
    const LoadInstant& load = instant.loads[i];
    const Link& link = p.system.links()[i];
    put_load(instant, load, link, &p.state[layout.offset(i)]);
    p.loading.loads.push_back(
        {vec3(link.axes.transpose() * load.active_force),
         vec3(link.axes.transpose() * load.active_moment_com),
         vec3(friction_axes(link).transpose() * load.friction_moment)});
  }
  return p;
}

InstantResult evaluate(const Instant& instant) {
  const Prepared p = prepare(instant);
  Dynamics dynamics = p.dynamics();
  dynamics.evaluate(p.state.data(), p.loading);

  const Vector3d gravity = instant.rotation.transpose() * instant.gravity;
  InstantResult result;
  result.acceleration_minus_gravity = vec3(dynamics.carrier().linear);
  result.acceleration = result.acceleration_minus_gravity + gravity;
  result.angular_acceleration = vec3(dynamics.carrier().angular);
  std::vector<Reaction<double>> reactions(p.system.size());
  dynamics.reactions(reactions);
  for (int i = 0; i < p.system.size(); ++i) {
    const LoadInstant& load = instant.loads[i];
    result.loads.push_back(
        load_result(load, p.system.links()[i], dynamics, reactions[i], i));
    result.loads.back().acceleration +=
        relative_rotation(load).transpose() * gravity;
  }
  return result;
}

}  // namespace multibody
