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

LoadInstant random_load(Random& random, JointKind kind, JointMode mode) {
  LoadInstant load;
  load.load.kind = kind;
  load.mode = mode;
  load.load.mass = random.uniform(1, 10);
  load.load.inertia = random.inertia(0.3 * load.load.mass);
  load.load.hinge_from_com = random.vector(1);
  load.load.hinge_from_carrier_com = random.vector(2);
  load.active_force = random.vector(100);
  load.active_moment_com = random.vector(30);
  load.friction_moment = random.vector(10);
  load.rotation = random.rotation();
  load.relative_angular_velocity = random.vector(3);
  load.angle = random.uniform(-3, 3);
  load.angle_rate = random.uniform(-3, 3);
  if (kind == JointKind::axis) {
    load.load.hinge_to_load = random.rotation();
    load.load.hinge_to_carrier_zero = random.rotation();
    load.rotation = axis_rotation(load.load, load.angle);
    load.relative_angular_velocity =
        load.angle_rate * load.load.hinge_to_load.col(2);
  }
  if (mode == JointMode::held) {
    load.relative_angular_velocity.setZero();
    load.angle_rate = 0;
  }
  return load;
}

}  // namespace

Instant random_instant(Mix mix, int loads, std::uint64_t seed) {
  Random random(seed);
  Instant instant;
  instant.carrier.mass = loads * random.uniform(5, 15);
  instant.carrier.inertia = random.inertia(2 * instant.carrier.mass);
  instant.gravity = {0.3, -0.2, -9.81};
  instant.rotation = random.rotation();
  instant.position = random.vector(10);
  instant.velocity = random.vector(10);
  instant.angular_velocity = random.vector(2);
  instant.active_force = random.vector(200);
  instant.active_moment_com = random.vector(50);
  struct Kind {
    JointKind joint;
    JointMode mode;
  };
  static constexpr Kind kinds[] = {{JointKind::spherical, JointMode::turning},
                                   {JointKind::axis, JointMode::turning},
                                   {JointKind::spherical, JointMode::held},
                                   {JointKind::axis, JointMode::held},
                                   {JointKind::none, JointMode::released}};
  for (int i = 0; i < loads; ++i) {
    const Kind kind = kinds[mix == Mix::spherical ? 0
                            : mix == Mix::axes    ? 1
                            : mix == Mix::held    ? 2 + i % 2
                                                  : i % 5];
    instant.loads.push_back(random_load(random, kind.joint, kind.mode));
  }
  return instant;
}

}  // namespace multibody::test
