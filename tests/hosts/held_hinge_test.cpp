// A held hinge in the loop of a host with explicit torques.
#include "hosts/held_hinge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace contact::test::held_hinge_test {
namespace {

using contact_hosts::HeldHinge;
using Eigen::Vector3d;

constexpr const char* file = CONTACT_HOST_TESTS "pin.toml";
constexpr double mass = 5, length = 0.4, inertia = 0.9, dt = 1e-3, g = 9.81;

// A pendulum about z, stepped as a host does that adds torques explicitly.
struct Pendulum {
  HeldHinge hinge{file};
  double angle = 1, rate = 0;
  Vector3d reaction{0, mass* g, 0};
  double side = 0;  // another torque, N m

  // @param assumed  inertia passed to the hinge
  void step(double assumed) {
    const double weight = -mass * g * length * std::sin(angle) + side;
    const double friction =
        hinge.torque(reaction, Vector3d::UnitZ(), rate, assumed, dt);
    const double acceleration = (weight + friction) / inertia;
    rate += dt * acceleration;
    angle += dt * rate;
    const Vector3d along(std::sin(angle), -std::cos(angle), 0);
    const Vector3d across(std::cos(angle), std::sin(angle), 0);
    reaction = mass * (length * (acceleration * across - rate * rate * along) +
                       Vector3d(0, g, 0));
  }
  // Time after which it turns by less than 1e-9 rad in a second, s.
  double rests_after(double assumed) {
    double since = angle;
    for (int i = 1; i < 200'000; ++i) {
      step(assumed);
      if (i % 1000 != 0) continue;
      if (std::abs(angle - since) < 1e-9) return i * dt;
      since = angle;
    }
    return INFINITY;
  }
};

TEST(HeldHinge, PendulumComesToRestAndStays) {
  Pendulum pendulum;
  const double time = pendulum.rests_after(inertia);
  ASSERT_TRUE(std::isfinite(time));
  const double angle = pendulum.angle;
  EXPECT_GT(std::abs(angle), 1e-6);
  for (int i = 0; i < 600'000; ++i) pendulum.step(inertia);  // ten minutes
  EXPECT_NEAR(pendulum.angle, angle, 1e-12);
  EXPECT_TRUE(pendulum.hinge.last().holds);
}

TEST(HeldHinge, InertiaNeedNotBeExact) {
  Pendulum exact;
  const double time = exact.rests_after(inertia);
  for (const double factor : {0.2, 0.5, 1.3}) {
    Pendulum wrong;
    EXPECT_NEAR(wrong.rests_after(factor * inertia), time, 1) << factor;
    EXPECT_NEAR(wrong.angle, exact.angle, 0.01 * std::abs(exact.angle) + 2e-3)
        << factor;
  }
  Pendulum unstable;
  EXPECT_FALSE(std::isfinite(unstable.rests_after(1.5 * inertia)));
}

TEST(HeldHinge, SlidingTorqueIsThatOfSolve) {
  HeldHinge hinge(file);
  const auto joint = contact_hosts::read_joint(file, "test", CONTACT_PIN);
  for (const double load : {10.0, 300.0, 5000.0}) {
    const contact_slip slip = {{load, 0, 0}, {0, 0, 2}, {0, 0, 1}};
    contact_solution s;
    contact_hosts::must(contact_joint_solve(joint.get(), &slip, nullptr, &s));
    const double torque =
        hinge.torque({load, 0, 0}, Vector3d::UnitZ(), 2, 2, 1e3, dt);
    EXPECT_NEAR(torque, s.friction_moment[2], 1e-12 * std::abs(torque));
  }
}

// The onset is at the limit of contact_joint_at_rest().
TEST(HeldHinge, LetsGoAtItsLimit) {
  const auto joint = contact_hosts::read_joint(file, "test", CONTACT_PIN);
  const contact_hold hold = {{0, mass * g, 0}, {0, 0, 1}, {0, 0, 1}};
  contact_rest rest;
  contact_hosts::must(
      contact_joint_at_rest(joint.get(), &hold, nullptr, &rest));
  const double limit = 1 / rest.utilisation;
  for (const double share : {0.99, 1.01}) {
    Pendulum held;
    held.angle = 0;
    // While the torque grows the hinge gives way by its growth in a step.
    for (int i = 0; i < 2000; ++i) {
      held.side = share * limit * std::min(i, 1000) / 1000;
      held.step(inertia);
    }
    // It slides until its weight takes what friction does not hold.
    EXPECT_EQ(std::abs(held.angle) > 1e-6, share > 1) << share;
  }
}

}  // namespace
}  // namespace contact::test::held_hinge_test
