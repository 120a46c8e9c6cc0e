// Bodies on bodies move: closed forms, momentum, energy, and the limits in
// which a tree is something else.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "libcontact/files/joint_file.hpp"
#include "multibody/motion/motion.hpp"
#include "multibody_support/friction_parts.hpp"
#include "multibody_support/momentum.hpp"
#include "multibody_support/random_instant.hpp"

namespace multibody::test::motion_tree_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double g = 9.81;

// Thin rods along x at angle 0, each on the end of the one before by an axis
// along y, the first on the carrier.
std::vector<Body> rods(int count, double length = 1, double mass = 1) {
  std::vector<Body> all;
  Matrix3d about_y;
  about_y << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  for (int i = 0; i < count; ++i) {
    Body rod{HingeKind::axis, mass, Matrix3d::Zero()};
    rod.inertia.diagonal() << 0, 1, 1;
    rod.inertia *= mass * length * length / 12;
    rod.hinge_from_com.x() = -length / 2;
    if (i > 0) rod.hinge_from_carrier_com.x() = length / 2;
    rod.hinge_to_body = rod.hinge_to_carrier_zero = about_y;
    rod.parent = i - 1;
    all.push_back(rod);
  }
  return all;
}

MotionOptions tight(const Vector3d& gravity = {0, 0, -g}) {
  MotionOptions options;
  options.gravity = gravity;
  options.relative_tolerance = 1e-12;
  options.absolute_tolerance = 1e-13;
  return options;
}

MotionStart at_angles(const std::vector<double>& angles) {
  MotionStart start;
  for (const double angle : angles) start.bodies.push_back({.angle = angle});
  return start;
}

double degrees(double angle) { return angle * 180 / std::numbers::pi; }

// 1 m, 1 kg, horizontal, at rest. Angles and rates by 30-digit Taylor series
// of the equations of the double pendulum.
TEST(MotionTree, TwoRodsFall) {
  Motion motion(System({.fixed = true}, rods(2)), {}, nullptr,
                at_angles({0, 0}), tight());
  const MotionSample& sample = motion.sample();
  EXPECT_NEAR(sample.angular_acceleration(1).y(), 9 / 7.0 * g, 1e-12);
  EXPECT_NEAR(sample.angular_acceleration(2).y(), -3 / 7.0 * g, 1e-12);
  EXPECT_NEAR(sample.hinge(0).reaction_force.z(), 2 / 7.0 * g, 1e-12);
  EXPECT_NEAR(sample.hinge(1).reaction_force.z(), -g / 14, 1e-12);
  const auto expect = [&](double time, const std::vector<double>& angles) {
    ASSERT_EQ(motion.advance_to(time), Stop::time);
    for (int i = 0; i < 2; ++i) {
      EXPECT_NEAR(degrees(sample.angle(i)), angles[i], 1e-8) << time;
    }
  };
  expect(0.5, {64.3233189141862, -34.0233947659629});
  expect(1, {159.19704329774, -22.5358748012673});
  EXPECT_NEAR(degrees(sample.hinge(0).angle_rate), 195.1790774766, 1e-8);
  EXPECT_NEAR(degrees(sample.hinge(1).angle_rate), -165.6118498882, 1e-8);
}

// Small swings of two equal rods: w^2 = (3 -+ 6/sqrt 7) g/l, with the second's
// absolute angle (+-2 sqrt 7 - 1)/3 of the first's.
TEST(MotionTree, DoublePendulumHasItsFrequencies) {
  const double down = std::numbers::pi / 2;
  for (const double sign : {-1.0, 1.0}) {
    const double w = std::sqrt((3 + sign * 6 / std::sqrt(7)) * g);
    const double ratio = (-sign * 2 * std::sqrt(7) - 1) / 3;
    constexpr double small = 1e-5;
    Motion motion(System({.fixed = true}, rods(2)), {}, nullptr,
                  at_angles({down + small, small * (ratio - 1)}), tight());
    motion.advance_to(3.3);
    const double swing = small * std::cos(w * 3.3);
    // The absolute tolerance of the steps is 1e-8 of it.
    EXPECT_NEAR(motion.sample().angle(0) - down, swing, 1e-7 * small);
    EXPECT_NEAR(motion.sample().angle(1), swing * (ratio - 1), 1e-7 * small);
  }
}

contact::Joint rough_pin(const char* coefficient) {
  return contact::Joint(
      contact::read_joint(CONTACT_DATA_DIR "/joints/pin_joint.toml",
                          {{"friction.coefficient", coefficient}}));
}

// Rods of 0.2 m and 2 kg on pins. Converged values of programs that share no
// code with this one but the joints: Runge and Kutta of 8th and 4th order,
// steps and tolerances down to 0.5 ms and 1e-13.
TEST(MotionTree, TriplePendulumComesToRest) {
  const double down = std::numbers::pi / 2;
  MotionOptions options = tight();
  options.relative_tolerance = 1e-11;
  options.absolute_tolerance = 1e-12;
  Motion motion(System({.fixed = true}, rods(3, 0.2, 2)),
                std::vector<HingeFriction>(3, JointFriction{rough_pin("0.5")}),
                nullptr, at_angles({down + 1, 0.5, -0.3}), options);
  const MotionSample& sample = motion.sample();
  const double energy = sample.energy().balance();
  EXPECT_EQ(sample.mode(1), HingeMode::resting);
  EXPECT_NEAR(sample.hinge(0).friction_moment.y(), 0.2219582962, 1e-9);
  EXPECT_NEAR(sample.hinge(1).reaction_moment.y(), 0.0839658706, 1e-9);
  EXPECT_NEAR(sample.angular_acceleration(1).y(), -30.0132339217, 1e-8);
  EXPECT_NEAR(
      sample.angular_acceleration(3).y() - sample.angular_acceleration(2).y(),
      46.4999527121, 1e-8);
  ASSERT_EQ(motion.advance_to(11), Stop::time) << motion.failure()->message();
  EXPECT_NEAR(motion.changes().front().time, 0.0249196852, 1e-9);
  EXPECT_NEAR(motion.changes().back().time, 9.8735788441, 1e-9);
  const double angles[] = {0.0136330679, 0.0072866279, -0.0052197664};
  const double moments[] = {0.2876625983, 0.1539263455, 0.0308019960};
  const double shares[] = {0.5463811398, 0.4385549320, 0.1755203121};
  for (int i = 0; i < 3; ++i) {
    const HingeSample hinge = sample.hinge(i);
    EXPECT_EQ(hinge.mode, HingeMode::resting);
    EXPECT_NEAR(hinge.angle - (i == 0 ? down : 0), angles[i], 1e-9);
    EXPECT_NEAR(hinge.reaction_moment.y(), moments[i], 1e-8);
    EXPECT_NEAR(hinge.utilisation, shares[i], 1e-8);
  }
  EXPECT_NEAR(sample.energy().dissipated, 11.2278879558, 1e-8);
  EXPECT_NEAR(sample.energy().balance(), energy, 1e-8);
}

// Nothing holds the chain together but what the driven hinge causes: beside it
// all reactions are 0, in floating point next to it.
TEST(MotionTree, RoundingMovesNoHingeInFreeFlight) {
  class Drive : public ForceModel {
    void add_forces(double, std::span<const BodyMotion>,
                    std::span<BodyForce> forces) const override {
      forces[9].moment.y() += 0.3;
      forces[8].moment.y() -= 0.3;
    }
  };
  const Carrier carrier{3, Matrix3d::Identity()};
  const std::vector<Body> bodies = rods(16, 0.2, 2);
  Motion motion(System(carrier, bodies),
                std::vector<HingeFriction>(16, JointFriction{rough_pin("0.2")}),
                std::make_shared<Drive>(),
                at_angles(std::vector<double>(16, 0.4)),
                tight(Vector3d::Zero()));
  ASSERT_FALSE(motion.failure()) << motion.failure()->message();
  EXPECT_EQ(motion.sample().mode(8), HingeMode::sliding);
  ASSERT_EQ(motion.advance_to(0.02), Stop::time) << motion.failure()->message();
  const Momentum p = momentum_of(motion.sample(), carrier, bodies);
  EXPECT_LE(p.angular.norm(), 1e-12);
}

// Bodies on any of those before them, on balls and axes.
struct Tree {
  Carrier carrier;
  std::vector<Body> bodies;
  std::vector<HingeFriction> friction;
  MotionStart start;
};

Tree random_tree(std::uint64_t seed, int size, bool friction) {
  Random random(seed);
  Tree tree{{8, random.inertia(1)}, {}, {}, {}};
  const contact::FrictionLaw law(0.15, 1e5);
  for (int i = 0; i < size; ++i) {
    const bool axis = random.uniform(0, 1) < 0.5;
    Body body{axis ? HingeKind::axis : HingeKind::ball, random.uniform(3, 6),
              random.inertia(0.2)};
    body.hinge_from_com = random.vector(0.3);
    body.hinge_from_carrier_com = random.vector(0.5);
    body.hinge_to_body = random.rotation();
    body.hinge_to_carrier_zero = random.rotation();
    body.parent = static_cast<int>(random.uniform(0, i + 1)) - 1;
    tree.bodies.push_back(body);
    BodyStart start;
    start.rotation = random.rotation();
    start.relative_angular_velocity = random.vector(2);
    start.angle = random.uniform(-1, 1);
    start.angle_rate = random.uniform(-2, 2);
    tree.start.bodies.push_back(start);
    if (!friction) {
      tree.friction.push_back({});
    } else if (axis) {
      tree.friction.push_back(JointFriction{pin_joint(law, 0.02)});
    } else {
      tree.friction.push_back(JointFriction{ball_joint(law, 0.02)});
    }
  }
  tree.start.carrier.velocity = random.vector(1);
  tree.start.carrier.position = random.vector(1);
  tree.start.carrier.angular_velocity = random.vector(1.5);
  return tree;
}

void expect_same(const Momentum& p, const Momentum& q, double bar) {
  EXPECT_LE((q.linear - p.linear).norm(), bar * p.linear.norm());
  EXPECT_LE((q.angular - p.angular).norm(), bar * p.angular.norm());
}

TEST(MotionTree, MomentumAndEnergyStay) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Tree t = random_tree(seed, 8, false);
    Motion motion(System(t.carrier, t.bodies), {}, nullptr, t.start,
                  tight(Vector3d::Zero()));
    const Momentum p = momentum_of(motion.sample(), t.carrier, t.bodies);
    const double energy = motion.sample().energy().balance();
    ASSERT_EQ(motion.advance_to(10), Stop::time);
    expect_same(p, momentum_of(motion.sample(), t.carrier, t.bodies), 1e-10);
    EXPECT_NEAR(motion.sample().energy().balance(), energy, 1e-10 * energy);
  }
}

// Moments that swing between each body and its parent.
class Swing : public ForceModel {
 public:
  explicit Swing(const std::vector<Body>& bodies) : bodies_(bodies) {}
  void add_forces(double time, std::span<const BodyMotion>,
                  std::span<BodyForce> forces) const override {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const double phase = 3 * time + static_cast<double>(i);
      const Vector3d moment(std::sin(phase), std::cos(0.7 * phase), 0.3);
      forces[1 + i].moment += moment;
      forces[1 + bodies_[i].parent].moment -= moment;
    }
  }

 private:
  std::vector<Body> bodies_;
};

// Through rest and onsets of balls and pins.
TEST(MotionTree, FrictionKeepsTheBooks) {
  std::size_t changes = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Tree t = random_tree(seed, 6, true);
    MotionOptions options;
    options.relative_tolerance = 1e-10;
    options.absolute_tolerance = 1e-11;
    Motion motion(System(t.carrier, t.bodies), t.friction,
                  std::make_shared<Swing>(t.bodies), t.start, options);
    const auto all = [&] {
      return momentum_of(motion.sample(), t.carrier, t.bodies);
    };
    const Momentum p = all();
    const double energy = motion.sample().energy().balance();
    ASSERT_EQ(motion.advance_to(5), Stop::time)
        << seed << ' ' << motion.failure()->message();
    expect_same(p, all(), 1e-8);
    const EnergyBook book = motion.sample().energy();
    EXPECT_NEAR(book.balance(), energy, 1e-8 * energy);
    EXPECT_GT(book.dissipated, 0);
    changes += motion.changes().size();
    std::printf(
        "seed %d: %zu changes, dissipated %.3g of %.3g J, error %.2g, "
        "%.2f outer\n",
        static_cast<int>(seed), motion.changes().size(), book.dissipated,
        energy, (book.balance() - energy) / energy,
        static_cast<double>(motion.counts().outer_iterations) /
            static_cast<double>(motion.counts().evaluations));
  }
  EXPECT_GT(changes, 50u);
}

// A carrier of 1e9 kg is ground: each branch moves for itself, as on ground.
TEST(MotionTree, HeavyRootIsGround) {
  Tree t = random_tree(3, 6, true);
  t.start.carrier.velocity.setZero();
  t.start.carrier.angular_velocity.setZero();
  t.carrier = {1e9, 1e9 * Matrix3d::Identity()};
  const auto at_end = [&] {
    MotionOptions options = tight(Vector3d::Zero());
    Motion motion(System(t.carrier, t.bodies), t.friction,
                  std::make_shared<Swing>(t.bodies), t.start, options);
    EXPECT_EQ(motion.advance_to(0.5), Stop::time);
    return motion.sample().body(5).position;
  };
  const Vector3d on_body = at_end();
  t.carrier = {.fixed = true};
  EXPECT_LE((at_end() - on_body).norm(), 1e-7);
}

// The sample's accelerations are the derivatives of its velocities.
TEST(MotionTree, AccelerationsAreThoseOfTheMotion) {
  const Tree t = random_tree(5, 6, false);
  Motion motion(System(t.carrier, t.bodies), {}, nullptr, t.start,
                tight({1, -3, 9}));
  constexpr double h = 1e-4;
  std::vector<BodyMotion> before, after;
  std::vector<Vector3d> linear, angular;
  motion.advance_to(h);
  const auto look = [&](std::vector<BodyMotion>& to) {
    to.assign(motion.sample().motions().begin(),
              motion.sample().motions().end());
  };
  look(before);
  motion.advance_to(2 * h);
  for (int i = 0; i <= 6; ++i) {
    linear.push_back(motion.sample().acceleration(i));
    angular.push_back(motion.sample().angular_acceleration(i));
  }
  motion.advance_to(3 * h);
  look(after);
  for (int i = 0; i <= 6; ++i) {
    // Second-order differences.
    const auto over = [&](auto member) -> Vector3d {
      return (after[i].*member - before[i].*member) / (2 * h);
    };
    EXPECT_LE((over(&BodyMotion::velocity) - linear[i]).norm(), 1e-3) << i;
    EXPECT_LE((over(&BodyMotion::angular_velocity) - angular[i]).norm(), 1e-3)
        << i;
  }
}

// The whole as one piece: mass, centre, inertia.
TEST(MotionTree, AllLockedIsARigidBody) {
  Tree t = random_tree(7, 8, false);
  for (BodyStart& start : t.start.bodies) {
    start.relative_angular_velocity.setZero();
    start.angle_rate = 0;
    start.locked = true;
  }
  Motion motion(System(t.carrier, t.bodies), {}, nullptr, t.start,
                tight(Vector3d::Zero()));
  motion.advance_to(2);
  const auto motions = motion.sample().motions();
  const Vector3d w = motions[0].angular_velocity;
  double mass = 0;
  Vector3d centre = Vector3d::Zero();
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const double own = i == 0 ? t.carrier.mass : t.bodies[i - 1].mass;
    mass += own;
    centre += own * motions[i].position;
  }
  centre /= mass;
  Matrix3d inertia = Matrix3d::Zero();
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const double own = i == 0 ? t.carrier.mass : t.bodies[i - 1].mass;
    const Matrix3d& r = motions[i].rotation;
    const Vector3d d = motions[i].position - centre;
    inertia +=
        r * (i == 0 ? t.carrier.inertia : t.bodies[i - 1].inertia) *
            r.transpose() +
        own * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
    EXPECT_LE((motions[i].angular_velocity - w).norm(), 1e-13 * w.norm());
  }
  const Vector3d w_dot = -inertia.ldlt().solve(w.cross(inertia * w));
  for (int i = 0; i <= 8; ++i) {
    const Vector3d d = motions[i].position - centre;
    EXPECT_LE((motion.sample().angular_acceleration(i) - w_dot).norm(),
              1e-13 * w.squaredNorm());
    EXPECT_LE((motion.sample().acceleration(i) -
               (w_dot.cross(d) + w.cross(w.cross(d))))
                  .norm(),
              1e-13 * w.squaredNorm());
  }
}

TEST(MotionTree, LocksKeepMomentum) {
  const Tree t = random_tree(6, 8, false);
  Motion motion(System(t.carrier, t.bodies), {}, nullptr, t.start,
                tight(Vector3d::Zero()));
  motion.advance_to(0.5);
  motion.save();  // at a step's end, as latch() does
  const Momentum p = momentum_of(motion.sample(), t.carrier, t.bodies);
  const double energy = motion.sample().energy().balance();
  for (int i = 0; i < 8; i += 2) motion.latch(i);
  expect_same(p, momentum_of(motion.sample(), t.carrier, t.bodies), 1e-12);
  EXPECT_NEAR(motion.sample().energy().balance(), energy, 1e-9 * energy);
  motion.advance_to(1);
  EXPECT_EQ(motion.sample().hinge(2).relative_angular_velocity.norm(), 0);
}

// A body that was released takes what hangs on it along.
TEST(MotionTree, ReleasedSubtreesGoOn) {
  Tree t = random_tree(8, 8, false);
  for (int i = 0; i < 8; ++i) t.bodies[i].parent = i == 4 ? -1 : i - 1;
  Motion motion(System(t.carrier, t.bodies), {}, nullptr, t.start,
                tight(Vector3d::Zero()));
  motion.advance_to(0.3);
  motion.save();
  const auto all = [&] {
    return momentum_of(motion.sample(), t.carrier, t.bodies);
  };
  const Momentum p = all();
  const double energy = motion.sample().energy().balance();
  const BodyMotion tip = motion.sample().body(7);
  motion.release(5);
  EXPECT_LE((motion.sample().body(7).velocity - tip.velocity).norm(), 1e-13);
  motion.latch(7);  // the released body receives its impulse
  expect_same(p, all(), 1e-12);
  motion.release(1);
  const MotionState saved = motion.save();
  ASSERT_EQ(motion.advance_to(2), Stop::time);
  expect_same(p, all(), 1e-10);
  EXPECT_NEAR(motion.sample().energy().balance(), energy, 1e-9 * energy);
  EXPECT_EQ(motion.sample().mode(7), HingeMode::latched);
  const Vector3d end = motion.sample().body(7).position;
  motion.restore(saved);
  motion.advance_to(2);
  EXPECT_EQ(motion.sample().body(7).position, end);
}

}  // namespace
}  // namespace multibody::test::motion_tree_test
