#include "multibody_support/random_instant.hpp"

#include <Eigen/Geometry>

namespace multibody::test {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d Random::vector(double size) {
  Vector3d v;
  for (double& x : v) x = uniform(-size, size);
  return v;
}

Matrix3d Random::rotation() {
  Eigen::Quaterniond q(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1),
                       uniform(-1, 1));
  return q.normalized().toRotationMatrix();
}

Matrix3d Random::inertia(double size) {
  // Moments of a box of sides squared in a ratio of 1 to 3.
  const Vector3d squares(uniform(0.5, 1.5), uniform(0.5, 1.5),
                         uniform(0.5, 1.5));
  const Vector3d moments = size * (squares.sum() * Vector3d::Ones() - squares);
  const Matrix3d axes = rotation();
  const Matrix3d inertia = axes * moments.asDiagonal() * axes.transpose();
  return 0.5 * (inertia + inertia.transpose());
}

namespace {

BodyInstant random_body(Random& random, HingeKind kind, JointMode mode) {
  BodyInstant body;
  body.body.kind = kind;
  body.mode = mode;
  body.body.mass = random.uniform(1, 10);
  body.body.inertia = random.inertia(0.3 * body.body.mass);
  body.body.hinge_from_com = random.vector(1);
  body.body.hinge_from_carrier_com = random.vector(2);
  body.active_force = random.vector(100);
  body.active_moment_com = random.vector(30);
  body.friction_moment = random.vector(10);
  body.rotation = random.rotation();
  body.relative_angular_velocity = random.vector(3);
  body.angle = random.uniform(-3, 3);
  body.angle_rate = random.uniform(-3, 3);
  if (kind == HingeKind::axis) {
    body.body.hinge_to_body = random.rotation();
    body.body.hinge_to_carrier_zero = random.rotation();
    body.rotation = axis_rotation(body.body, body.angle);
    body.relative_angular_velocity =
        body.angle_rate * body.body.hinge_to_body.col(2);
  }
  if (mode == JointMode::held) {
    body.relative_angular_velocity.setZero();
    body.angle_rate = 0;
  }
  return body;
}

}  // namespace

Instant random_instant(Mix mix, int bodies, std::uint64_t seed) {
  Random random(seed);
  Instant instant;
  instant.carrier.mass = bodies * random.uniform(5, 15);
  instant.carrier.inertia = random.inertia(2 * instant.carrier.mass);
  instant.gravity = {0.3, -0.2, -9.81};
  instant.rotation = random.rotation();
  instant.position = random.vector(10);
  instant.velocity = random.vector(10);
  instant.angular_velocity = random.vector(2);
  instant.active_force = random.vector(200);
  instant.active_moment_com = random.vector(50);
  struct Kind {
    HingeKind joint;
    JointMode mode;
  };
  static constexpr Kind kinds[] = {{HingeKind::ball, JointMode::turning},
                                   {HingeKind::axis, JointMode::turning},
                                   {HingeKind::ball, JointMode::held},
                                   {HingeKind::axis, JointMode::held},
                                   {HingeKind::none, JointMode::released}};
  for (int i = 0; i < bodies; ++i) {
    const Kind kind = kinds[mix == Mix::balls  ? 0
                            : mix == Mix::axes ? 1
                            : mix == Mix::held ? 2 + i % 2
                                               : i % 5];
    instant.bodies.push_back(random_body(random, kind.joint, kind.mode));
  }
  return instant;
}

}  // namespace multibody::test
