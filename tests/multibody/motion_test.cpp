#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <vector>

#include "multibody/motion/motion.hpp"
#include "multibody_support/friction_parts.hpp"
#include "multibody_support/momentum.hpp"
#include "multibody_support/random_instant.hpp"
#include "multibody_support/wheel.hpp"
#include "support/error_message.hpp"

// Motions against closed forms: energies and momenta are balanced, and a saved
// run continues bit-identically.
namespace multibody::test::motion_test {
namespace {

using contact::FrictionLaw;

TEST(Motion, ForcesThatAreTakenAwayActNoLonger) {
  const double about = 0.4;
  Motion motion(System(heavy_carrier(), {wheel(20, about)}), {},
                std::make_shared<Torque>([](double) { return 2.0; }),
                start_of(1), on_fixed_carrier());
  motion.advance_to(1);
  EXPECT_NEAR(motion.sample().hinge(0).angle_rate, 2 / about, 1e-9);
  motion.set_forces(nullptr);
  motion.advance_to(2);
  EXPECT_NEAR(motion.sample().hinge(0).angle_rate, 2 / about, 1e-9);
}

// A free carrier with bodies of all kinds that move and come to rest on it.
struct Mixed {
  Carrier carrier;
  std::vector<Body> bodies;
  std::vector<HingeFriction> friction;
  MotionStart start;
};

Mixed mixed_system(std::uint64_t seed, bool friction) {
  multibody::test::Random random(seed);
  Mixed m{{50, random.inertia(5)}, {}, {}, start_of(4)};
  const FrictionLaw law(0.15, 1e5);
  for (int i = 0; i < 4; ++i) {
    Body body{i % 2 ? HingeKind::axis : HingeKind::ball, random.uniform(3, 6),
              random.inertia(0.2)};
    body.hinge_from_com = random.vector(0.3);
    body.hinge_from_carrier_com = random.vector(0.6);
    body.hinge_to_body = random.rotation();
    body.hinge_to_carrier_zero = random.rotation();
    m.bodies.push_back(body);
    BodyStart& start = m.start.bodies[i];
    start.rotation = random.rotation();
    start.relative_angular_velocity = random.vector(2);
    start.angle = random.uniform(-1, 1);
    start.angle_rate = random.uniform(-2, 2);
    if (!friction) {
      m.friction.push_back({});
    } else if (i % 2) {
      m.friction.push_back(GroupFriction{ball_and_pin(law, 0.2)});
    } else {
      m.friction.push_back(JointFriction{ball_joint(law, 0.02)});
    }
  }
  m.start.carrier.velocity = random.vector(1);
  m.start.carrier.position = random.vector(1);
  m.start.carrier.angular_velocity = random.vector(1.5);
  return m;
}

TEST(Motion, EnergyWithDissipatedWorkAndMomentaStay) {
  for (const bool friction : {false, true}) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const Mixed m = mixed_system(seed, friction);
      MotionOptions options;
      options.relative_tolerance = 1e-10;
      options.absolute_tolerance = 1e-11;
      Motion motion(System(m.carrier, m.bodies), m.friction, nullptr, m.start,
                    options);
      const double energy = motion.sample().energy().balance();
      const Momentum p = momentum_of(motion.sample(), m.carrier, m.bodies);
      ASSERT_EQ(motion.advance_to(20), Stop::time)
          << motion.failure()->message();
      const auto book = motion.sample().energy();
      EXPECT_NEAR(book.balance(), energy, 1e-8 * energy);
      const Momentum q = momentum_of(motion.sample(), m.carrier, m.bodies);
      EXPECT_LT((q.linear - p.linear).norm(), 1e-8 * p.linear.norm());
      EXPECT_LT((q.angular - p.angular).norm(), 1e-8 * p.angular.norm());
      std::printf(
          "seed %d: %zu changes, dissipated %.3g of %.3g J, error "
          "%.2g, %ld evaluations, %ld steps, %.2f outer\n",
          static_cast<int>(seed), motion.changes().size(), book.dissipated,
          energy, (book.balance() - energy) / energy,
          motion.counts().evaluations, motion.counts().steps,
          static_cast<double>(motion.counts().outer_iterations) /
              static_cast<double>(motion.counts().evaluations));
      if (friction) {
        EXPECT_GT(book.dissipated, 0);
      }
    }
  }
}

// Forces and moments on all bodies that swing, each at its own phase.
class Shake : public ForceModel {
 public:
  Shake(const Vector3d& force, const Vector3d& moment, double rate)
      : force_(force), moment_(moment), rate_(rate) {}
  void add_forces(double time, std::span<const BodyMotion>,
                  std::span<BodyForce> forces) const override {
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const double phase = rate_ * time + static_cast<double>(i);
      forces[i].force += force_ * std::sin(phase);
      forces[i].moment += moment_ * std::cos(0.7 * phase);
    }
  }

 private:
  Vector3d force_, moment_;
  double rate_;
};

// Random carriers with one to four bodies of all kinds and sizes of friction,
// shaken: all run through, with the energy in balance.
TEST(Motion, RandomSystemsRunThrough) {
  std::size_t changes = 0;
  double worst = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    multibody::test::Random random(seed);
    const int count = 1 + static_cast<int>(seed % 4);
    const FrictionLaw law(std::pow(10, random.uniform(-2, -0.4)),
                          seed % 3 == 0 ? 0 : 1e4);
    const double radius = std::pow(10, random.uniform(-2.3, -1));
    const Carrier carrier{random.uniform(20, 100), random.inertia(5)};
    std::vector<Body> bodies;
    std::vector<HingeFriction> friction;
    MotionStart start;
    start.carrier.angular_velocity = random.vector(seed % 2 == 0 ? 0.0 : 1.0);
    for (int i = 0; i < count; ++i) {
      const bool axis = random.uniform(0, 1) < 0.5;
      Body body{axis ? HingeKind::axis : HingeKind::ball, random.uniform(2, 8),
                random.inertia(0.3)};
      body.hinge_from_com = random.vector(i % 3 == 0 ? 0.01 : 0.4);
      body.hinge_from_carrier_com = random.vector(0.6);
      body.hinge_to_body = random.rotation();
      body.hinge_to_carrier_zero = random.rotation();
      bodies.push_back(body);
      BodyStart& at = start.bodies.emplace_back();
      at.rotation = random.rotation();
      if (random.uniform(0, 1) < 0.5) {
        at.relative_angular_velocity = random.vector(2);
        at.angle_rate = random.uniform(-2, 2);
      }
      if (!axis) {
        friction.emplace_back(JointFriction{ball_joint(law, radius)});
      } else if (random.uniform(0, 1) < 0.5) {
        friction.emplace_back(JointFriction{pin_joint(law, radius)});
      } else {
        friction.emplace_back(GroupFriction{ball_and_pin(law, 0.3)});
      }
    }
    const auto shake = std::make_shared<Shake>(
        random.vector(20), random.vector(3), random.uniform(1, 10));
    MotionOptions options;
    options.relative_tolerance = 1e-10;
    options.absolute_tolerance = 1e-11;
    Motion motion(System(carrier, bodies), friction, shake, start, options);
    const double before = motion.sample().energy().balance();
    ASSERT_EQ(motion.advance_to(5), Stop::time)
        << seed << ": " << motion.failure()->message();
    const auto book = motion.sample().energy();
    const double size = before + book.kinetic + std::abs(book.active_work);
    worst = std::max(worst, std::abs(book.balance() - before) / size);
    changes += motion.changes().size();
  }
  EXPECT_LT(worst, 1e-7);
  std::printf("%zu changes of hinges, energy %.2g\n", changes, worst);
}

// All bodies fall alike under forces in proportion to their masses: hinges
// carry only rounding.
class Fall : public ForceModel {
 public:
  explicit Fall(std::vector<double> masses) : masses_(std::move(masses)) {}
  void add_forces(double, std::span<const BodyMotion>,
                  std::span<BodyForce> forces) const override {
    for (std::size_t i = 0; i < masses_.size(); ++i) {
      forces[i].force += masses_[i] * Vector3d(0.1, -9.81, 3.3);
    }
  }

 private:
  std::vector<double> masses_;
};

TEST(Motion, RoundingMovesNoHinge) {
  for (const bool sliding : {false, true}) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      Mixed m = mixed_system(seed, true);
      std::vector<double> masses = {m.carrier.mass};
      m.start.carrier.angular_velocity.setZero();
      for (int i = 0; i < 4; ++i) {
        masses.push_back(m.bodies[i].mass);
        if (i > 0 || !sliding) {
          m.start.bodies[i].relative_angular_velocity.setZero();
          m.start.bodies[i].angle_rate = 0;
        } else {
          // Balanced: it turns on without active its hinge.
          m.bodies[i].hinge_from_com.setZero();
          m.bodies[i].inertia = 0.2 * Matrix3d::Identity();
        }
      }
      Motion motion(System(m.carrier, m.bodies), m.friction,
                    std::make_shared<Fall>(masses), m.start);
      ASSERT_EQ(motion.advance_to(100), Stop::time)
          << motion.failure()->message();
      EXPECT_TRUE(motion.changes().empty()) << seed;
    }
  }
}

// Mass on a thread of length l, from rest at 2 rad: a quarter period is
// K(sin 1) sqrt(l/g).
TEST(Motion, PendulumMeetsItsEllipticPeriod) {
  const double l = 0.8, amplitude = 2;
  const double quarter =
      std::comp_ellint_1(std::sin(amplitude / 2)) * std::sqrt(l / g);
  for (const HingeKind kind : {HingeKind::axis, HingeKind::ball}) {
    Body body{kind, 3, Matrix3d::Zero()};
    body.hinge_from_com = Vector3d(0, l, 0);
    MotionStart start = start_of(1);
    start.bodies[0].angle = amplitude;
    start.bodies[0].rotation =
        Eigen::AngleAxisd(amplitude, Vector3d::UnitZ()).toRotationMatrix();
    MotionOptions options = on_fixed_carrier();
    options.relative_tolerance = options.absolute_tolerance = 1e-11;
    Motion motion(System(heavy_carrier(), {body}), {}, nullptr, start, options);
    const int below = motion.add_event(
        {[](const MotionSample& s) { return s.body(0).position.x(); },
         MotionEvent::Crossing::either});
    for (int i = 0; i < 3; ++i) {
      ASSERT_EQ(motion.advance_to(100), Stop::event);
      EXPECT_EQ(motion.event(), below);
      EXPECT_NEAR(motion.time(), (2 * i + 1) * quarter, 1e-9 * quarter * 6);
    }
  }
}

// A spring that is wound up for turns: forces and events see the angle with
// full turns counted, I x'' = -k x.
TEST(Motion, AnglesOfAxesCountFullTurns) {
  class Spring : public ForceModel {
   public:
    void add_forces(double, std::span<const BodyMotion> bodies,
                    std::span<BodyForce> forces) const override {
      forces[1].moment.z() -= 1.8 * bodies[1].hinge_angle;
    }
  };
  const double about = 0.4, first = 30;
  const double level = 800 * std::numbers::pi / 180;
  const double rate = std::sqrt(1.8 / about);
  for (const Integrator integrator : {Integrator::adaptive, Integrator::rk4}) {
    MotionOptions options = on_fixed_carrier(integrator);
    MotionStart start = start_of(1);
    start.bodies[0].angle = first;
    Motion motion(System(heavy_carrier(), {wheel(20, about)}), {},
                  std::make_shared<Spring>(), start, options);
    motion.add_event(
        {[&](const MotionSample& s) { return s.angle(0) - level; }});
    const double down = std::acos(level / first) / rate;
    const double period = 2 * std::numbers::pi / rate;
    for (const double time : {down, period - down, period + down}) {
      ASSERT_EQ(motion.advance_to(100), Stop::event);
      // Error control of 1e-9 of 30 rad in each step; 4e-10 s was seen.
      EXPECT_NEAR(motion.time(), time, 5e-9);
      EXPECT_NEAR(motion.sample().angle(0), level, 1e-7);
      EXPECT_EQ(motion.sample().body(0).hinge_angle, motion.sample().angle(0));
    }
    motion.release(0);
    const double then = motion.sample().body(0).hinge_angle;
    EXPECT_NEAR(then, level, 1e-7);
    const MotionState saved = motion.save();
    motion.advance_to(2 * period);
    EXPECT_EQ(motion.sample().body(0).hinge_angle, then);
    Motion other(System(heavy_carrier(), {wheel(20, about)}), {}, nullptr,
                 start, options);
    other.restore(saved);
    EXPECT_EQ(other.sample().body(0).hinge_angle, then);
    EXPECT_TRUE(std::isnan(other.sample().carrier().hinge_angle));
  }
}

// Gyrostat: a free body with a balanced wheel. Without forces the wheel's spin
// in space about its axis and the total momentum stay constant; the body
// precesses like a symmetrical body with the wheel's momentum.
TEST(Motion, GyrostatPrecessesAsItShould) {
  const double across = 4, along = 6, wheel_along = 0.5, wheel_across = 0.3;
  Carrier carrier{50, Matrix3d::Zero()};
  carrier.inertia.diagonal() << across, across, along;
  Body body{HingeKind::axis, 5, Matrix3d::Zero()};
  body.inertia.diagonal() << wheel_across, wheel_across, wheel_along;
  MotionStart start = start_of(1);
  const double spin = 40, tilt = 0.2, turn = 0.7;
  start.bodies[0].angle_rate = spin;
  start.carrier.angular_velocity = Vector3d(tilt, 0, turn);
  MotionOptions options;
  options.relative_tolerance = options.absolute_tolerance = 1e-11;
  Motion motion(System(carrier, {body}), {}, nullptr, start, options);
  const double t = 10;
  ASSERT_EQ(motion.advance_to(t), Stop::time);
  // (I1 + J1) w_x' = -(h - (I1 + J1) w_z) w_y with h the momentum along z.
  const double total = across + wheel_across;
  const double h = along * turn + wheel_along * (turn + spin);
  const double rate = h / total - turn;
  const BodyMotion& seen = motion.sample().carrier();
  const Vector3d w = seen.rotation.transpose() * seen.angular_velocity;
  EXPECT_NEAR(w.x(), tilt * std::cos(rate * t), 1e-8);
  EXPECT_NEAR(w.y(), tilt * std::sin(rate * t), 1e-8);
  EXPECT_NEAR(w.z(), turn, 1e-12);
  EXPECT_NEAR(motion.sample().hinge(0).angle_rate, spin, 1e-9);
}

// A torque that jumps, at times that are no multiples of the step: the rate is
// its integral.
TEST(Motion, ForcesJumpWhereTheySay) {
  class Pulse : public ForceModel {
   public:
    void add_forces(double time, std::span<const BodyMotion>,
                    std::span<BodyForce> forces) const override {
      if (time >= 0.25 && time < 0.7013) forces[1].moment.z() += 3;
    }
    double next_break(double time) const override {
      return time < 0.25     ? 0.25
             : time < 0.7013 ? 0.7013
                             : std::numeric_limits<double>::infinity();
    }
  };
  const double about = 0.4;
  const System system(heavy_carrier(), {wheel(20, about)});
  for (const Integrator integrator : {Integrator::adaptive, Integrator::rk4}) {
    MotionOptions options = on_fixed_carrier(integrator, 0.01);
    Motion motion(system, {}, std::make_shared<Pulse>(), start_of(1), options);
    // A watcher of the steps sees the torque on both sides of its jumps.
    std::map<double, double> seen;
    double last = 0;
    motion.watch_steps([&](const MotionSample& sample) {
      EXPECT_GE(sample.time(), last);
      last = sample.time();
      seen[last] = about * sample.angular_acceleration(1).z();
    });
    ASSERT_EQ(motion.advance_to(1), Stop::time);
    for (const auto& [time, torque] : seen) {
      EXPECT_LT(time, 1);
      EXPECT_NEAR(torque, time >= 0.25 && time < 0.7013 ? 3 : 0, 1e-14) << time;
    }
    for (const double jump : {0.25, 0.7013}) {
      EXPECT_TRUE(seen.contains(jump));
      EXPECT_TRUE(seen.contains(std::nextafter(jump, 0)));
    }
    EXPECT_GE(static_cast<long>(seen.size()), motion.counts().steps);
    const double rate = 3 * (0.7013 - 0.25) / about;
    // Constant accelerations are integrated exactly, except for rounding.
    EXPECT_NEAR(motion.sample().hinge(0).angle_rate, rate, 1e-12 * rate);
    if (integrator == Integrator::adaptive) {
      EXPECT_LT(motion.counts().steps, 30);
    }
  }
}

// The wheel whose damper limits explicit steps is reported, and a halted motion
// continues as if it had not been halted.
TEST(Motion, HaltsBetweenStepsAndKnowsWhatHoldsThem) {
  class Damper : public ForceModel {
   public:
    void add_forces(double, std::span<const BodyMotion> bodies,
                    std::span<BodyForce> forces) const override {
      forces[2].moment.z() -= 1e4 * bodies[2].angular_velocity.z();
    }
  };
  const System system(heavy_carrier(), {wheel(20, 0.4), wheel(20, 0.4)});
  for (const Integrator integrator : {Integrator::adaptive, Integrator::rk4}) {
    MotionOptions options = on_fixed_carrier(integrator, 5e-5);
    MotionStart start = start_of(2);
    start.bodies[0].angle_rate = start.bodies[1].angle_rate = 2;
    const auto make = [&] {
      return Motion(system, {}, std::make_shared<Damper>(), start, options);
    };
    Motion whole = make();
    ASSERT_EQ(whole.advance_to(0.1), Stop::time);
    Motion motion = make();
    int asked = 0;
    double end = 0;
    motion.halt_when([&] {
      end = motion.step_begin() + motion.last_step();
      return ++asked % 100 == 0;
    });
    int halts = 0;
    while (motion.advance_to(0.1) == Stop::halted) {
      ++halts;
      EXPECT_EQ(motion.counts().steps, 100 * halts - halts);
      EXPECT_EQ(motion.time(), end);
      EXPECT_EQ(motion.sample().time(), end);
      EXPECT_EQ(motion.held_by(), integrator == Integrator::rk4 ? -1 : 2);
    }
    EXPECT_GT(halts, 5);
    EXPECT_FALSE(motion.failure());
    EXPECT_EQ(motion.time(), 0.1);
    EXPECT_EQ(motion.save().numbers, whole.save().numbers);
  }
}

TEST(Motion, RungeKuttaIsOfFourthOrder) {
  const Mixed m = mixed_system(7, false);
  const auto end = [&](double step, Integrator integrator) {
    MotionOptions options;
    options.integrator = integrator;
    options.step = step;
    options.relative_tolerance = options.absolute_tolerance = 1e-13;
    Motion motion(System(m.carrier, m.bodies), m.friction, nullptr, m.start,
                  options);
    motion.advance_to(2);
    return motion.sample().body(2).position;
  };
  const Vector3d exact = end(1, Integrator::adaptive);
  double last = 0;
  for (const double step : {0.02, 0.01, 0.005, 0.0025}) {
    const double error = (end(step, Integrator::rk4) - exact).norm();
    if (last > 0) {
      const double order = std::log2(last / error);
      std::printf("step %g: error %.3g, order %.3f\n", step, error, order);
      EXPECT_NEAR(order, 4, 0.15);
    }
    last = error;
  }
}

TEST(Motion, RotationsStayOrthogonalOverAMillionSteps) {
  Body body{HingeKind::ball, 2, 0.1 * Matrix3d::Identity()};
  body.hinge_from_com = Vector3d(0, 0.3, 0);
  MotionStart start = start_of(1);
  start.bodies[0].relative_angular_velocity = Vector3d(3, 1, 5);
  start.carrier.angular_velocity = Vector3d(0.3, 0.2, -0.5);
  MotionOptions options;
  options.integrator = Integrator::rk4;
  options.step = 2e-3;
  Motion motion(System(heavy_carrier(), {body}), {}, nullptr, start, options);
  ASSERT_EQ(motion.advance_to(2000), Stop::time);
  EXPECT_GE(motion.counts().steps, 1'000'000);
  for (const BodyMotion& seen : motion.sample().motions()) {
    const Matrix3d miss =
        seen.rotation.transpose() * seen.rotation - Matrix3d::Identity();
    EXPECT_LT(miss.cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_GT(seen.rotation.determinant(), 0);
  }
}

// All queries at its present time, and back in its step.
void look_around(const Motion& motion, multibody::test::Random& random,
                 double& seen) {
  const auto ask = [&](const MotionSample& sample) {
    for (int i = 0; i < 4; ++i) {
      const HingeSample hinge = sample.hinge(i);
      seen += hinge.reaction_force.norm() + hinge.friction_moment.norm();
      for (const auto& joint : hinge.joints) seen += joint.half_angle;
      seen += sample.angular_acceleration(1 + i).norm();
    }
    seen += sample.energy().kinetic;
  };
  if (random.uniform(0, 1) < 0.5) ask(motion.sample());
  const double begin = motion.step_begin();
  const double time =
      begin + random.uniform(0, 1) * (motion.sample().time() - begin);
  if (random.uniform(0, 1) < 0.5) motion.look_back(time, ask);
  if (random.uniform(0, 1) < 0.5) {
    // The same, of one body alone; to the rounding of the polynomials.
    motion.look_back(time, [&](const MotionSample& sample) {
      for (int i = 0; i <= 4; ++i) {
        const BodyMotion& all = sample.motions()[i];
        const BodyMotion one = motion.place_back(i, time);
        EXPECT_LE((one.position - all.position).norm(),
                  1e-13 * (1 + all.position.norm()));
        EXPECT_LE((one.velocity - all.velocity).norm(),
                  1e-13 * (1 + all.velocity.norm()));
        EXPECT_LE((one.rotation - all.rotation).norm(), 1e-13);
        EXPECT_LE((one.angular_velocity - all.angular_velocity).norm(),
                  1e-13 * (1 + all.angular_velocity.norm()));
      }
    });
  }
  if (random.uniform(0, 1) < 0.5) ask(motion.sample());
}

TEST(Motion, LooksOnTheWayLeaveNoTrace) {
  for (const Integrator integrator : {Integrator::adaptive, Integrator::rk4}) {
    for (const bool events : {false, true}) {
      const Mixed m = mixed_system(3, true);
      MotionOptions options;
      options.integrator = integrator;
      options.step = 5e-3;
      const auto begin = [&] {
        auto motion = std::make_unique<Motion>(
            System(m.carrier, m.bodies), m.friction, nullptr, m.start, options);
        if (events) {
          motion->add_event({[](const MotionSample& s) {
            return s.hinge(0).reaction_force.norm() - 20;
          }});
        }
        return motion;
      };
      const auto plain = begin();
      while (plain->advance_to(10) == Stop::event) continue;
      const auto looked = begin();
      multibody::test::Random random(1);
      double seen = 0;
      looked->watch_steps([&](const MotionSample&) {
        if (random.uniform(0, 1) < 0.3) look_around(*looked, random, seen);
      });
      for (double t = 0; t < 10;) {
        t = std::min(10.0, t + random.uniform(0, 0.1));
        while (looked->advance_to(t) == Stop::event) continue;
        ASSERT_EQ(looked->time(), t);
        look_around(*looked, random, seen);
      }
      EXPECT_GT(seen, 0);
      EXPECT_GT(plain->changes().size(), 3u);  // hinges that come to rest
      EXPECT_EQ(looked->counts().evaluations, plain->counts().evaluations);
      EXPECT_EQ(looked->changes().size(), plain->changes().size());
      EXPECT_EQ(looked->sample().hinge(1).reaction_force,
                plain->sample().hinge(1).reaction_force);
      EXPECT_EQ(looked->save().numbers, plain->save().numbers);
    }
  }
}

TEST(Motion, GoesOnFromASavedStateAsIfNothingHadHappened) {
  const Mixed m = mixed_system(3, true);
  const System system(m.carrier, m.bodies);
  MotionOptions options;
  options.integrator = Integrator::rk4;
  options.step = 5e-3;
  Motion one(system, m.friction, nullptr, m.start, options);
  one.advance_to(1);
  const MotionState saved = one.save();
  one.advance_to(2);
  Motion other(system, m.friction, nullptr, m.start, options);
  other.restore(saved);
  EXPECT_EQ(other.time(), 1);
  other.advance_to(2);
  for (int i = 0; i <= 4; ++i) {
    // The joint solvers start from elsewhere.
    EXPECT_LT((one.sample().motions()[i].position -
               other.sample().motions()[i].position)
                  .norm(),
              1e-9);
  }
}

TEST(Motion, ReleasedBodiesGoOnAsFreeBodies) {
  const Mixed m = mixed_system(5, true);
  Motion motion(System(m.carrier, m.bodies), m.friction, nullptr, m.start);
  motion.advance_to(0.5);
  motion.save();  // at a step's end, as release() does
  const Momentum p = momentum_of(motion.sample(), m.carrier, m.bodies);
  const BodyMotion before = motion.sample().body(1);
  motion.release(1);
  EXPECT_EQ(motion.sample().mode(1), HingeMode::released);
  EXPECT_LT((motion.sample().body(1).velocity - before.velocity).norm(), 1e-14);
  EXPECT_LT((motion.sample().body(1).rotation - before.rotation).norm(), 1e-14);
  motion.release(0);
  motion.release(2);
  motion.release(3);
  ASSERT_EQ(motion.advance_to(1.5), Stop::time);
  const Vector3d drifted = before.position + before.velocity;
  EXPECT_LT((motion.sample().body(1).position - drifted).norm(), 1e-9);
  const Momentum q = momentum_of(motion.sample(), m.carrier, m.bodies);
  EXPECT_LT((q.linear - p.linear).norm(), 1e-9 * p.linear.norm());
  EXPECT_LT((q.angular - p.angular).norm(), 1e-8 * p.angular.norm());
}

TEST(Motion, LatchesKeepMomentumAndHold) {
  const Mixed m = mixed_system(6, true);
  Motion motion(System(m.carrier, m.bodies), m.friction, nullptr, m.start);
  motion.advance_to(0.5);
  motion.save();  // at a step's end, as latch() does
  const Momentum p = momentum_of(motion.sample(), m.carrier, m.bodies);
  const double energy = motion.sample().energy().balance();
  for (int i = 0; i < 4; ++i) motion.latch(i);
  const Momentum q = momentum_of(motion.sample(), m.carrier, m.bodies);
  EXPECT_LT((q.linear - p.linear).norm(), 1e-12 * p.linear.norm());
  EXPECT_LT((q.angular - p.angular).norm(), 1e-12 * p.angular.norm());
  EXPECT_NEAR(motion.sample().energy().balance(), energy, 1e-9 * energy);
  motion.advance_to(1);
  EXPECT_EQ(motion.sample().hinge(2).relative_angular_velocity.norm(), 0);
  EXPECT_EQ(motion.sample().mode(2), HingeMode::latched);
  motion.unlock(2);
  EXPECT_NE(motion.sample().mode(2), HingeMode::latched);
}

TEST(Motion, BadInputIsRefusedByName) {
  const auto with = [](const MotionStart& start,
                       const MotionOptions& options = {},
                       const std::vector<HingeFriction>& friction = {},
                       const Carrier& carrier = heavy_carrier()) {
    const System system(carrier, {wheel(1, 1)});
    return contact::test::error_message(
        [&] { Motion(system, friction, nullptr, start, options); });
  };
  EXPECT_EQ(
      with(start_of(1), {}, {JointFriction{ball_joint(FrictionLaw(0.1))}}),
      "bodies[0].friction: a ball joint alone requires a ball hinge");
  EXPECT_EQ(with(start_of(2)),
            "start of 2 bodies must be of 1, one for each body");
  MotionStart start = turning(std::nan(""));
  EXPECT_EQ(with(start), "start.bodies[0] must be finite");
  start.bodies[0].angle_rate = 1;
  start.bodies[0].locked = true;
  EXPECT_EQ(with(start),
            "start.bodies[0]: relative velocity must be 0 while the body is "
            "locked");
  MotionOptions options;
  options.step = 0;
  EXPECT_EQ(with(start_of(1), options), "motion: step = 0 must be above 0");
  // A fixed carrier stays where it is.
  const Carrier fixed{.fixed = true};
  EXPECT_EQ(with(start_of(1), {}, {}, fixed), "(no error)");
  EXPECT_EQ(with(start_of(1), on_fixed_carrier(), {}, fixed),
            "motion: carrier_drive conflicts with a fixed carrier");
  MotionStart moving = start_of(1);
  moving.carrier.velocity.x() = 1;
  EXPECT_EQ(with(moving, {}, {}, fixed),
            "start.carrier: velocity must be 0: the carrier is fixed");
}

}  // namespace
}  // namespace multibody::test::motion_test
