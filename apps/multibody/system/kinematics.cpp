#include "multibody/system/kinematics.hpp"

#include <Eigen/Geometry>

#include "multibody/system/eigen_conversion.hpp"
#include "multibody/system/hinges/kinds.hpp"

namespace multibody {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d vector_at(const double* s) { return {s[0], s[1], s[2]}; }

BodyMotion free_body(const double* s, const Matrix3d& axes) {
  const Matrix3d r = rotation_at(s + StateLayout::rotation);
  return {vector_at(s + StateLayout::position),
          vector_at(s + StateLayout::velocity), r * axes.transpose(),
          r * vector_at(s + StateLayout::angular_velocity)};
}

template <class Hinge>
BodyMotion hung_body(Hinge hinge, const Link& link, const double* s,
                     const BodyMotion& parent) {
  const Matrix3d r = parent.rotation * hinge.rotation(link, s);
  const Vector3d w = parent.angular_velocity + r * hinge.rate(s);
  const Vector3d place = parent.rotation * link.hinge;
  const Vector3d arm = link.arm * Vector3d(r.col(Hinge::traits.arm_axis));
  return {parent.position + place - arm,
          parent.velocity + parent.angular_velocity.cross(place) - w.cross(arm),
          r * link.axes.transpose(), w, hinge.angle(s)};
}

void normalise_at(double* q) { Eigen::Map<Eigen::Vector4d>(q).normalize(); }

}  // namespace

Matrix3d relative_rotation(const Link& link, const double* s) {
  return with_hinge(link.kind,
                    [&](auto hinge) { return hinge.rotation(link, s); });
}

Vector3d relative_rate(const Link& link, const double* s) {
  return with_hinge(link.kind, [&](auto hinge) { return hinge.rate(s); });
}

void set_relative_rate(const Link& link, double* s, const Vector3d& rate) {
  with_hinge(link.kind, [&](auto hinge) { hinge.set_rate(s, rate); });
}

BodyMotion carrier_at(const double* s) {
  return free_body(s, Matrix3d::Identity());
}

BodyMotion body_at(const Link& link, JointMode mode, const double* s,
                   const BodyMotion& parent) {
  if (mode == JointMode::released) return free_body(s, link.axes);
  return with_hinge(
      link.kind, [&](auto hinge) { return hung_body(hinge, link, s, parent); });
}

void set_bodies(const System& system, const StateLayout& layout,
                std::span<const JointMode> modes, const double* state,
                std::span<BodyMotion> bodies) {
  bodies[0] = carrier_at(state);
  for (const int i : system.order()) {
    const double angle = bodies[1 + i].hinge_angle;
    const Link& link = system.links()[i];
    bodies[1 + i] = body_at(link, modes[i], state + layout.offset(i),
                            bodies[1 + link.parent]);
    if (modes[i] == JointMode::released) bodies[1 + i].hinge_angle = angle;
  }
}

void set_active_forces(const System& system, std::span<const BodyMotion> bodies,
                       std::span<const BodyForce> forces,
                       ActiveForces<double>& active) {
  const Matrix3d& r0 = bodies[0].rotation;
  active.carrier.force = vec3(Vector3d(r0.transpose() * forces[0].force));
  active.carrier.moment = vec3(Vector3d(r0.transpose() * forces[0].moment));
  for (int i = 0; i < system.size(); ++i) {
    const Matrix3d r = bodies[1 + i].rotation * system.links()[i].axes;
    const BodyForce& f = forces[1 + i];
    active.bodies[i].force = vec3(Vector3d(r.transpose() * f.force));
    active.bodies[i].moment = vec3(Vector3d(r.transpose() * f.moment));
  }
}

void put_body(const BodyMotion& body, const Matrix3d& axes, double* to) {
  const Matrix3d r = body.rotation * axes;
  const Eigen::Quaterniond q(r);
  const Vector3d w = r.transpose() * body.angular_velocity;
  Eigen::Map<Vector3d>(to + StateLayout::position) = body.position;
  Eigen::Map<Vector3d>(to + StateLayout::velocity) = body.velocity;
  Eigen::Map<Eigen::Vector4d>(to + StateLayout::rotation) =
      Eigen::Vector4d(q.w(), q.x(), q.y(), q.z()).normalized();
  Eigen::Map<Vector3d>(to + StateLayout::angular_velocity) = w;
}

double kinetic_energy(double mass, const Matrix3d& inertia,
                      const Matrix3d& axes, const BodyMotion& body) {
  const Vector3d w = (body.rotation * axes).transpose() * body.angular_velocity;
  return 0.5 * (mass * body.velocity.squaredNorm() + w.dot(inertia * w));
}

void normalise(const System& system, const StateLayout& layout,
               std::span<const JointMode> modes, double* state) {
  normalise_at(state + StateLayout::rotation);
  for (int i = 0; i < system.size(); ++i) {
    double* s = state + layout.offset(i);
    if (modes[i] == JointMode::released) {
      normalise_at(s + StateLayout::rotation);
      continue;
    }
    const int quaternion = hinge_traits(system.links()[i].kind).quaternion;
    if (quaternion >= 0) normalise_at(s + quaternion);
  }
}

}  // namespace multibody
