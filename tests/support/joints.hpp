#pragma once

#include <memory>

#include "libcontact/half_angle/factory.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/pressure/cosine.hpp"

/// Joints of steel in steel with the paper's laws, for tests that use joints.
namespace contact::test {

inline const ElasticPair steel_in_steel({2e11, 0.3}, {2e11, 0.3});

/// Uses the law tanh by default.
inline Joint steel_ball(const FrictionModel& friction,
                        JointBody inner = JointBody::carrier,
                        const char* law = "tanh") {
  const JointKind ball = JointKind::ball;
  return Joint({JointGeometry::ball(0.05, 0.05e-3, inner), steel_in_steel,
                friction, make_half_angle_law(law, ball, steel_in_steel),
                std::make_unique<CosinePressure>(ball)});
}

inline Joint steel_pin(const FrictionModel& friction,
                       JointBody inner = JointBody::carrier,
                       double length = 0.1) {
  const JointKind pin = JointKind::pin;
  return Joint({JointGeometry::pin(0.04, 4e-5, length, inner), steel_in_steel,
                friction, make_half_angle_law("blend", pin, steel_in_steel),
                std::make_unique<CosinePressure>(pin)});
}

}  // namespace contact::test
