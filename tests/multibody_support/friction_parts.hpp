#pragma once

#include <memory>

#include "libcontact/half_angle/factory.hpp"
#include "libcontact/joint/cylindrical_joint.hpp"
#include "libcontact/joint/node.hpp"
#include "libcontact/joint/spherical_joint.hpp"
#include "libcontact/pressure/cosine.hpp"

/// Joints of steel for tests of motions.
namespace multibody::test {

inline contact::ElasticPair steel_pair() {
  return contact::ElasticPair({2e11, 0.3}, {2e11, 0.3});
}

inline contact::SphericalJoint ball_joint(
    const contact::FrictionModel& friction, double radius = 0.05) {
  const contact::ElasticPair pair = steel_pair();
  return {
      contact::JointGeometry::ball(radius, 1e-3 * radius), pair, friction,
      contact::make_half_angle_law("tanh", contact::JointKind::spherical, pair),
      std::make_unique<contact::CosinePressure>(contact::JointKind::spherical)};
}

inline contact::CylindricalJoint pin_joint(
    const contact::FrictionModel& friction, double radius = 0.05) {
  const contact::ElasticPair pair = steel_pair();
  return {contact::JointGeometry::pin(radius, 1e-3 * radius, 0.1), pair,
          friction,
          contact::make_half_angle_law("tanh", contact::JointKind::cylindrical,
                                       pair),
          std::make_unique<contact::CosinePressure>(
              contact::JointKind::cylindrical)};
}

/// A ball and a pin, `distance` apart about the hinge's centre.
inline contact::JointNode ball_and_pin(const contact::FrictionModel& friction,
                                       double distance) {
  std::vector<contact::NodeJoint> joints;
  joints.push_back({ball_joint(friction, 0.02), -distance / 2});
  joints.push_back({pin_joint(friction, 0.02), distance / 2});
  return contact::JointNode(std::move(joints));
}

}  // namespace multibody::test
