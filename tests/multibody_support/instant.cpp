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

// The carrier's numbers, and a released body's.
void put_body(const Vector3d& position, const Vector3d& velocity,
              const Matrix3d& rotation, const Vector3d& angular_velocity,
              double* to) {
  put_vector(position, to + StateLayout::position);
  put_vector(velocity, to + StateLayout::velocity);
  put_rotation(rotation, to + StateLayout::rotation);
  put_vector(angular_velocity, to + StateLayout::angular_velocity);
}

// C and the relative angular velocity, body axes.
Matrix3d relative_rotation(const BodyInstant& body) {
  return body.body.kind == HingeKind::axis
             ? axis_rotation(body.body, body.angle)
             : body.rotation;
}
Vector3d relative_velocity(const BodyInstant& body) {
  return body.body.kind == HingeKind::axis
             ? Vector3d(body.angle_rate * body.body.hinge_to_body.col(2))
             : body.relative_angular_velocity;
}

void put_body(const Instant& instant, const BodyInstant& body, const Link& link,
              double* to) {
  const Matrix3d rotation = relative_rotation(body) * link.axes;
  const Vector3d relative = link.axes.transpose() * relative_velocity(body);
  if (body.mode == JointMode::released) {
    const Vector3d w =
        relative + rotation.transpose() * instant.angular_velocity;
    put_body(Vector3d::Zero(), Vector3d::Zero(), instant.rotation * rotation, w,
             to);
  } else if (link.kind == HingeKind::axis) {
    to[0] = body.angle;
    to[1] = body.angle_rate;
  } else {
    put_rotation(rotation, to);
    put_vector(relative, to + 4);
  }
}

Matrix3d friction_axes(const Link& link) {
  return link.kind == HingeKind::axis ? link.axes_to_hinge : link.axes;
}

BodyResult body_result(const BodyInstant& body, const Link& link,
                       const Dynamics& dynamics,
                       const Reaction<double>& reaction, int i) {
  const Matrix3d& axes = link.axes;
  const Vector3d relative = vec3(dynamics.relative_acceleration(i));
  BodyResult result;
  result.angular_acceleration = axes * vec3(dynamics.angular_acceleration(i));
  result.relative_angular_acceleration = body.mode == JointMode::released
                                             ? Vector3d::Zero()
                                             : Vector3d(axes * relative);
  result.angle_acceleration = relative.z();
  result.reaction_force = axes * vec3(reaction.force);
  result.reaction_moment = axes * vec3(reaction.moment);
  result.reaction_moment_hinge = friction_axes(link) * vec3(reaction.moment);
  result.acceleration = (body.active_force + result.reaction_force) / link.mass;
  return result;
}

// Accelerations of the centres of mass of bodies on bodies, computed outward
// from the carrier, because the reactions of light links cancel.
void accelerate_outward(const Instant& instant, const System& system,
                        InstantResult& result) {
  std::vector<Vector3d> velocities(instant.bodies.size());
  struct Motion {
    Vector3d acceleration, angular, w;
    Vector3d at(const Vector3d& place) const {
      return acceleration + angular.cross(place) + w.cross(w.cross(place));
    }
  };
  for (const int i : system.order()) {
    const BodyInstant& body = instant.bodies[i];
    const int parent = body.body.parent;
    const Matrix3d to_body = relative_rotation(body).transpose();
    const Motion up =
        parent < 0 ? Motion{result.acceleration, result.angular_acceleration,
                            instant.angular_velocity}
                   : Motion{result.bodies[parent].acceleration,
                            result.bodies[parent].angular_acceleration,
                            velocities[parent]};
    velocities[i] = to_body * up.w + relative_velocity(body);
    const Motion own{to_body * up.at(body.body.hinge_from_carrier_com),
                     result.bodies[i].angular_acceleration, velocities[i]};
    result.bodies[i].acceleration = own.at(-body.body.hinge_from_com);
  }
}

}  // namespace

Matrix3d axis_rotation(const Body& body, double angle) {
  const Eigen::AngleAxisd turn(angle, Vector3d::UnitZ());
  return body.hinge_to_carrier_zero * turn.toRotationMatrix() *
         body.hinge_to_body.transpose();
}

Dynamics Prepared::dynamics() const {
  Dynamics result(system);
  for (int i = 0; i < result.size(); ++i) result.set_mode(i, modes[i]);
  return result;
}

Prepared prepare(const Instant& instant) {
  std::vector<Body> bodies;
  std::vector<JointMode> modes;
  for (const BodyInstant& body : instant.bodies) {
    bodies.push_back(body.body);
    modes.push_back(body.mode);
  }
  Prepared p{System(instant.carrier, bodies), std::move(modes), {}, {}};
  const StateLayout layout(p.system, p.modes);
  p.state.resize(layout.size());
  put_body(instant.position, instant.velocity, instant.rotation,
           instant.angular_velocity, p.state.data());
  p.forces.carrier.force = vec3(instant.active_force);
  p.forces.carrier.moment = vec3(instant.active_moment_com);
  for (int i = 0; i < p.system.size(); ++i) {
    const BodyInstant& body = instant.bodies[i];
    const Link& link = p.system.links()[i];
    put_body(instant, body, link, &p.state[layout.offset(i)]);
    p.forces.bodies.push_back(
        {vec3(link.axes.transpose() * body.active_force),
         vec3(link.axes.transpose() * body.active_moment_com),
         vec3(friction_axes(link).transpose() * body.friction_moment)});
  }
  return p;
}

InstantResult evaluate(const Instant& instant) {
  const Prepared p = prepare(instant);
  Dynamics dynamics = p.dynamics();
  const Vector3d gravity = instant.rotation.transpose() * instant.gravity;
  if (instant.carrier.fixed) {
    dynamics.evaluate_prescribed(p.state.data(), p.forces,
                                 {vec3(Vector3d(-gravity)), {}});
  } else {
    dynamics.evaluate(p.state.data(), p.forces);
  }
  InstantResult result;
  result.acceleration_minus_gravity = vec3(dynamics.carrier().linear);
  result.acceleration = result.acceleration_minus_gravity + gravity;
  result.angular_acceleration = vec3(dynamics.carrier().angular);
  std::vector<Reaction<double>> reactions(p.system.size());
  dynamics.reactions(reactions);
  for (int i = 0; i < p.system.size(); ++i) {
    const BodyInstant& body = instant.bodies[i];
    result.bodies.push_back(
        body_result(body, p.system.links()[i], dynamics, reactions[i], i));
    result.bodies.back().acceleration +=
        relative_rotation(body).transpose() * gravity;
  }
  if (!p.system.is_star()) accelerate_outward(instant, p.system, result);
  return result;
}

}  // namespace multibody
