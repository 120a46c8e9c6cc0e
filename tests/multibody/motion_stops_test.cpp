// Stops and latches of bodies on axes against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "multibody/motion/motion.hpp"

namespace multibody::test::motion_stops_test {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

// 2 N m on the body about z, the opposite on the carrier.
class Motor : public ForceModel {
 public:
  void add_forces(double, std::span<const BodyMotion>,
                  std::span<BodyForce> forces) const override {
    forces[1].moment.z() += 2;
    forces[0].moment.z() -= 2;
  }
};

// A boom at -90 deg and at rest, which the motor drives to a stop at 0.
Motion boom(const Carrier& carrier, const Body& body,
            std::vector<HingeStop> stops) {
  MotionStart start;
  start.bodies.emplace_back().angle = -pi / 2;
  MotionOptions options;
  options.relative_tolerance = 1e-12;
  options.absolute_tolerance = 1e-13;
  options.stops = std::move(stops);
  return {
      System(carrier, {body}), {}, std::make_shared<Motor>(), start, options};
}

Body on_axis(double mass, double inertia, double reach) {
  Body body;
  body.kind = HingeKind::axis;
  body.mass = mass;
  body.inertia = inertia * Eigen::Matrix3d::Identity();
  body.hinge_from_com = {-reach, 0, 0};
  return body;
}

// J = 15 kg m^2 on the ground, e = 0.4: under a constant moment the rate at the
// first impact is sqrt(pi a), a = 2/15 rad/s^2, and flights last 2 e^n w/a.
TEST(Stops, BouncesOnTheGroundAreAGeometricSeries) {
  Carrier ground;
  ground.fixed = true;
  const double e = 0.4, a = 2.0 / 15;
  Motion motion = boom(ground, on_axis(1, 15, 0), {{0, 0, -1, e}});
  ASSERT_EQ(motion.advance_to(13), Stop::time);
  const double w = std::sqrt(pi * a);
  const double first = w / a;
  ASSERT_GT(motion.impacts().size(), 8u);
  double time = first;
  for (int n = 0; n < 3; ++n) {
    const HingeImpact& impact = motion.impacts()[n];
    EXPECT_NEAR(impact.time, time, 1e-9);
    EXPECT_NEAR(impact.rate, w * std::pow(e, n), 1e-9);
    EXPECT_NEAR(impact.impulse, 15 * (1 + e) * w * std::pow(e, n), 1e-8);
    time += 2 * std::pow(e, n + 1) * w / a;
  }
  EXPECT_NEAR(motion.changes().back().time, first + 2 * w * e / (a * (1 - e)),
              1e-8);
  EXPECT_TRUE(motion.changes().back().on_stop);
  EXPECT_NEAR(motion.sample().energy().impacts, pi, 1e-9);
  EXPECT_NEAR(std::abs(motion.sample().hinge(0).stop_moment), 2, 1e-9);
}

// On a free bus that answers: the first impact by quadrature of the energy
// (3.92142495076 s), and no bounce is missed: they take all of 2 N m pi/2.
TEST(Stops, FreeCarriersTakePart) {
  const Carrier bus{200, 35 * Eigen::Matrix3d::Identity()};
  Body body = on_axis(5, 3.75, 1.5);
  body.hinge_from_carrier_com = {0.5, 0, 0};
  Motion motion = boom(bus, body, {{0, 0, -1, 0.5}});
  ASSERT_EQ(motion.advance_to(13), Stop::time);
  ASSERT_GT(motion.impacts().size(), 8u);
  EXPECT_NEAR(motion.impacts()[0].time, 3.92142495076, 1e-9);
  EXPECT_NEAR(motion.sample().energy().impacts, pi, 1e-9);
  EXPECT_NEAR(motion.sample().energy().balance(), 0, 1e-9);
  EXPECT_NEAR(motion.sample().carrier().angular_velocity.z(), 0, 1e-10);
}

// Two rotors on the axis of a free bus: 1 N m presses the first on its stop, 2
// N m drive the second to another, from where the bus drives the first into its
// stop. It stays there: the second meets bus and first rotor as one body, and
// the impulse at the first stop is that which takes the first rotor along.
TEST(Stops, BodiesAtRestOnTheirsStayThere) {
  class Drives : public ForceModel {
   public:
    void add_forces(double, std::span<const BodyMotion>,
                    std::span<BodyForce> forces) const override {
      forces[1].moment.z() -= 1;
      forces[2].moment.z() += 2;
      forces[0].moment.z() -= 1;
    }
  };
  const Carrier bus{200, 35 * Eigen::Matrix3d::Identity()};
  const double first = 6, second = 3, e = 0.5;
  MotionStart start;
  start.bodies.resize(2);
  start.bodies[1].angle = -1;
  MotionOptions options;
  options.stops = {{0, 0, 1, 0.3}, {1, 0, -1, e}};
  Motion motion(System(bus, {on_axis(1, first, 0), on_axis(1, second, 0)}), {},
                std::make_shared<Drives>(), start, options);
  ASSERT_EQ(motion.advance_to(3), Stop::time);
  ASSERT_GE(motion.impacts().size(), 2u);
  const HingeImpact& stays = motion.impacts()[0];
  const HingeImpact& hits = motion.impacts()[1];
  EXPECT_EQ(stays.body, 0);
  EXPECT_EQ(hits.body, 1);
  EXPECT_EQ(stays.time, hits.time);
  EXPECT_EQ(stays.rate, 0);
  const double both = 35 + first;
  const double response = 1 / second + 1 / both;
  // Bus and first rotor move as one under -2 N m.
  EXPECT_NEAR(hits.rate, std::sqrt(2 * 2 * response), 1e-9);
  EXPECT_NEAR(hits.impulse, (1 + e) * hits.rate / response, 1e-9);
  EXPECT_NEAR(stays.impulse, first * hits.impulse / both, 1e-9);
  EXPECT_NEAR(hits.loss, (1 - e * e) * hits.rate * hits.rate / (2 * response),
              1e-9);
  EXPECT_EQ(motion.sample().hinge(0).angle_rate, 0);
  EXPECT_TRUE(motion.changes().empty() || motion.changes()[0].body == 1);
  EXPECT_NEAR(motion.sample().energy().balance(), 0, 1e-9);
}

// A latch removes the relative velocity and conserves the momentum: 7.488 N m
// s; when all is at rest, the bus has turned by -27.5757 deg.
TEST(Latches, KeepMomentum) {
  const Carrier bus{200, 35 * Eigen::Matrix3d::Identity()};
  Body body = on_axis(5, 3.75, 1.5);
  body.hinge_from_carrier_com = {0.5, 0, 0};
  Motion motion = boom(bus, body, {});
  ASSERT_EQ(motion.advance_to(3.92142495076), Stop::time);
  motion.latch(0);
  ASSERT_EQ(motion.impacts().size(), 1u);
  EXPECT_NEAR(motion.impacts()[0].impulse, 7.488338235624, 1e-8);
  EXPECT_NEAR(motion.sample().energy().impacts, pi, 1e-9);
  ASSERT_EQ(motion.advance_to(5), Stop::time);
  const Eigen::Matrix3d r = motion.sample().carrier().rotation;
  EXPECT_NEAR(std::atan2(r(1, 0), r(0, 0)) * 180 / pi, -27.575692697172, 1e-7);
  EXPECT_EQ(motion.sample().hinge(0).mode, HingeMode::latched);
}

}  // namespace
}  // namespace multibody::test::motion_stops_test
