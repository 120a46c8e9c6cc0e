#pragma once

#include <Eigen/Core>
#include <vector>

#include "multibody/motion/motion_sample.hpp"
#include "multibody/system/system.hpp"

namespace multibody::test {

/// Momentum of all bodies about the origin, inertial axes.
struct Momentum {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();
};

inline Momentum momentum_of(const MotionSample& sample, const Carrier& carrier,
                            const std::vector<Body>& bodies) {
  Momentum p;
  for (std::size_t i = 0; i <= bodies.size(); ++i) {
    const BodyMotion& body = sample.motions()[i];
    const double mass = i == 0 ? carrier.mass : bodies[i - 1].mass;
    const Eigen::Matrix3d inertia =
        i == 0 ? carrier.inertia : bodies[i - 1].inertia;
    p.linear += mass * body.velocity;
    p.angular += mass * body.position.cross(body.velocity) +
                 body.rotation * inertia * body.rotation.transpose() *
                     body.angular_velocity;
  }
  return p;
}

}  // namespace multibody::test
