#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "multibody/motion/motion.hpp"
#include "multibody_support/friction_parts.hpp"
#include "multibody_support/random_instant.hpp"
#include "multibody_support/wheel.hpp"

// Hinges that begin to slide beside sliding ones: their direction is well
// defined, although the tolerance of friction is of the size of their small
// initial acceleration.
namespace multibody::test::motion_onset_test {
namespace {

using contact::FrictionLaw;

struct Spring {
  int body;
  Vector3d point, carrier_point;
  double stiffness, free_length;
};

// Between points of bodies and of the carrier.
class Springs : public ForceModel {
 public:
  explicit Springs(std::vector<Spring> springs)
      : springs_(std::move(springs)) {}
  void add_forces(double, std::span<const BodyMotion> bodies,
                  std::span<BodyForce> forces) const override {
    for (const Spring& spring : springs_) {
      const BodyMotion& body = bodies[1 + spring.body];
      const Vector3d end = body.point(spring.point);
      const Vector3d begin = bodies[0].point(spring.carrier_point);
      const Vector3d line = end - begin;
      const double pull =
          spring.stiffness * (1 - spring.free_length / line.norm());
      forces[1 + spring.body].add_at(body, end, -pull * line);
      forces[0].add_at(bodies[0], begin, pull * line);
    }
  }

 private:
  std::vector<Spring> springs_;
};

struct Coupled {
  Carrier carrier;
  std::vector<Body> bodies;
  std::vector<HingeFriction> friction;
  MotionStart start;
  std::vector<Spring> springs;
};

double log_uniform(Random& random, double low, double high) {
  return std::exp(random.uniform(std::log(low), std::log(high)));
}

HingeFriction random_friction(Random& random, HingeKind kind) {
  const FrictionLaw law(random.uniform(0.05, 0.75), 0);
  const double radius = log_uniform(random, 0.005, 0.08);
  if (kind == HingeKind::ball) return JointFriction{ball_joint(law, radius)};
  if (random.uniform(0, 1) < 0.5) {
    return JointFriction{pin_joint(law, radius)};
  }
  return GroupFriction{ball_and_pin(law, random.uniform(0.2, 0.8))};
}

// A free carrier with two to four bodies on dry pins and balls, all of them at
// rest; springs of some of them make all of them move.
Coupled random_coupled(std::uint64_t seed) {
  Random random(seed);
  Coupled c;
  c.carrier = {log_uniform(random, 20, 400), random.inertia(100)};
  const int count = 2 + static_cast<int>(seed % 3);
  for (int i = 0; i < count; ++i) {
    const bool axis = random.uniform(0, 1) < 0.7;
    const double mass = log_uniform(random, 2, 60);
    Body body{axis ? HingeKind::axis : HingeKind::ball, mass,
              random.inertia(0.3 * mass)};
    body.hinge_from_com = random.vector(0.5);
    body.hinge_from_carrier_com = random.vector(1.5);
    body.hinge_to_body = random.rotation();
    body.hinge_to_carrier_zero = random.rotation();
    c.bodies.push_back(body);
    c.friction.push_back(random_friction(random, body.kind));
    c.start.bodies.emplace_back().rotation = random.rotation();
    if (i == 0 || random.uniform(0, 1) < 0.3) {
      c.springs.push_back({i, random.vector(2), random.vector(4),
                           log_uniform(random, 100, 5000),
                           random.uniform(0.5, 2)});
    }
  }
  return c;
}

// Changes of a hinge that the next one takes back at once.
int false_changes(const std::vector<HingeChange>& changes) {
  int count = 0;
  for (std::size_t k = 0; k < changes.size(); ++k) {
    const auto next = std::find_if(
        changes.begin() + static_cast<std::ptrdiff_t>(k) + 1, changes.end(),
        [&](const HingeChange& c) { return c.body == changes[k].body; });
    if (next == changes.end() || changes[k].to != HingeMode::sliding) continue;
    count += next->time - changes[k].time < 1e-9;
  }
  return count;
}

// All seeds from 0 to 299 run through. With accelerations no better than the
// tolerance of friction two of them ended early, 222 and 273, and a hinge of
// 107 turned about 4e-13 s after it had begun to slide.
TEST(MotionOnset, CoupledHingesRunThrough) {
  std::vector<std::uint64_t> seeds = {107, 222, 273};
  for (std::uint64_t seed = 0; seed < 60; ++seed) seeds.push_back(seed);
  std::size_t changes = 0;
  double worst = 0;
  for (const std::uint64_t seed : seeds) {
    const Coupled c = random_coupled(seed);
    Motion motion(System(c.carrier, c.bodies), c.friction,
                  std::make_shared<Springs>(c.springs), c.start);
    const double before = motion.sample().energy().balance();
    ASSERT_EQ(motion.advance_to(3), Stop::time)
        << seed << ": " << motion.failure()->message();
    EXPECT_EQ(false_changes(motion.changes()), 0) << seed;
    const auto book = motion.sample().energy();
    // Friction may hold all of them.
    const double size = 1e-9 + book.kinetic + std::abs(book.active_work);
    worst = std::max(worst, std::abs(book.balance() - before) / size);
    changes += motion.changes().size();
  }
  EXPECT_LT(worst, 1e-6);
  EXPECT_GT(changes, 2000U);
  std::printf("%zu changes of hinges, energy %.2g\n", changes, worst);
}

}  // namespace
}  // namespace multibody::test::motion_onset_test
