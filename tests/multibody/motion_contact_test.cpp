#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "multibody/motion/motion.hpp"
#include "multibody/motion/stepper.hpp"
#include "multibody_support/friction_parts.hpp"

// Motions whose contacts reach the end of their law, and steps that reach it.
namespace multibody::test::motion_contact_test {
namespace {

using contact::FrictionLaw;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// A force along x and a torque about z on body 0.
class Pull : public ForceModel {
 public:
  using Function = std::function<double(double)>;
  Pull(Function force, Function torque)
      : force_(std::move(force)), torque_(std::move(torque)) {}
  void add_forces(double time, std::span<const BodyMotion>,
                  std::span<BodyForce> forces) const override {
    forces[1].force.x() += force_(time);
    forces[1].moment.z() += torque_(time);
  }

 private:
  Function force_, torque_;
};

constexpr double radius = 0.02;
constexpr double law_end = 1e5;  // R_n, N
const FrictionLaw friction(0.2);

LawPointer ending(const contact::JointContact& contact) {
  return std::make_shared<EndingLaw>(contact.geometry().kind(),
                                     contact.load_parameter(law_end));
}
contact::Joint ending_ball() {
  return ball_joint(friction, radius,
                    ending(ball_joint(friction, radius).contact()));
}
contact::Joint ending_pin() {
  return pin_joint(friction, radius,
                   ending(pin_joint(friction, radius).contact()));
}

// A hinge with one joint whose law ends.
struct Hinge {
  std::string name;
  HingeKind kind;
  HingeFriction friction;
  int joint;     // the one
  double share;  // part of the force that it takes
};

std::vector<Hinge> hinges() {
  std::vector<Hinge> all;
  for (const auto estimate :
       {FrictionEstimate::consistent, FrictionEstimate::traditional}) {
    const std::string by =
        estimate == FrictionEstimate::consistent ? "" : ", traditional";
    all.push_back({"ball" + by, HingeKind::ball,
                   JointFriction{ending_ball(), estimate}, 0, 1});
    all.push_back({"pin" + by, HingeKind::axis,
                   JointFriction{ending_pin(), estimate}, 0, 1});
    for (const int joint : {0, 1}) {
      std::vector<contact::JointGroup::Member> joints;
      joints.push_back(
          {joint == 0 ? ending_ball() : ball_joint(friction, radius), -1});
      joints.push_back(
          {joint == 1 ? ending_pin() : pin_joint(friction, radius), 1});
      all.push_back(
          {fmt::format("node, joint {}{}", joint, by), HingeKind::axis,
           GroupFriction{contact::JointGroup(joints), estimate}, joint, 0.5});
    }
  }
  return all;
}

class ContactEnds : public testing::TestWithParam<Integrator> {
 protected:
  // The force as a share of that under which the joint's law ends.
  static std::shared_ptr<Pull> pull(const Hinge& hinge, Pull::Function share,
                                    double torque) {
    return std::make_shared<Pull>(
        [share = std::move(share), end = law_end / hinge.share](double time) {
          return share(time) * end;
        },
        [torque](double) { return torque; });
  }
  static Motion motion(const Hinge& hinge, std::shared_ptr<Pull> forces,
                       double rate, bool locked = false) {
    // So heavy that friction, 800 N m, hardly slows it down.
    const Body body{hinge.kind, 1000, 1e5 * Matrix3d::Identity()};
    MotionOptions options;
    options.carrier_drive = CarrierDrive{};
    options.integrator = GetParam();
    options.step = 0.02;
    options.longest_step = 6;
    MotionStart start;
    start.bodies.resize(1);
    start.bodies[0].relative_angular_velocity.z() = rate;
    start.bodies[0].angle_rate = rate;
    start.bodies[0].locked = locked;
    return Motion(System({100, 50 * Matrix3d::Identity()}, {body}),
                  {hinge.friction}, std::move(forces), start, options);
  }
  // It has failed as it should, at a time from `from` to `to`, under forces
  // that go with them.
  static void expect_failure(const Motion& motion, const Hinge& hinge,
                             double from, double to,
                             const Pull::Function& share) {
    ASSERT_TRUE(motion.failure());
    const MotionFailure& failure = *motion.failure();
    EXPECT_EQ(failure.status, CoupledStatus::no_contact) << failure.message();
    EXPECT_EQ(failure.body, 0);
    EXPECT_EQ(failure.joint, hinge.joint);
    EXPECT_GE(failure.time, from);
    EXPECT_LE(failure.time, to);
    EXPECT_LE(motion.time(), failure.time);
    EXPECT_GE(motion.time(), failure.time - 0.02);
    double time = NAN, force = NAN;
    int joint = -1;
    ASSERT_EQ(std::sscanf(failure.message().c_str(),
                          "at %lf s: half-angle law ending has no value under "
                          "%lf N (body 0, joint %d)",
                          &time, &force, &joint),
              3)
        << failure.message();
    EXPECT_EQ(time, failure.time);
    EXPECT_EQ(joint, hinge.joint);
    // Friction moments across the axis body the joints of a node a little.
    EXPECT_NEAR(force, share(time) * law_end, 1e-3 * force);
    EXPECT_TRUE(motion.sample().body(0).velocity.allFinite());
  }
  // Passes 1 at 5 s, and 1/cos g by 5.2 s.
  static double rising(double time) { return 0.5 + 0.1 * time; }
};

TEST_P(ContactEnds, WhileItSlides) {
  for (const Hinge& hinge : hinges()) {
    SCOPED_TRACE(hinge.name);
    Motion m = motion(hinge, pull(hinge, rising, 0), 10);
    EXPECT_EQ(m.advance_to(20), Stop::failed);
    EXPECT_EQ(m.sample().mode(0), HingeMode::sliding);
    expect_failure(m, hinge, 4.9, 5.25, rising);
  }
}

TEST_P(ContactEnds, AtRest) {
  for (const Hinge& hinge : hinges()) {
    for (const double torque : {0., 50.}) {
      SCOPED_TRACE(fmt::format("{}, {} N m", hinge.name, torque));
      Motion m = motion(hinge, pull(hinge, rising, torque), 0);
      EXPECT_EQ(m.sample().mode(0), HingeMode::resting);
      EXPECT_EQ(m.advance_to(20), Stop::failed);
      EXPECT_EQ(m.sample().mode(0), HingeMode::resting);
      expect_failure(m, hinge, 4.9, 5.25, rising);
    }
  }
}

// Only within a step, and back again before its end: steps of 6 s do not pass
// over the 4 s by more than half.
TEST_P(ContactEnds, InAPeakAtRest) {
  const auto peak = [](double time) {
    return 1.06 - 0.01 * (time - 10) * (time - 10);
  };
  for (const Hinge& hinge : hinges()) {
    SCOPED_TRACE(hinge.name);
    Motion m = motion(hinge, pull(hinge, peak, 50), 0);
    EXPECT_EQ(m.advance_to(20), Stop::failed);
    expect_failure(m, hinge, 7.5, 8.1, peak);
  }
}

// It slides before: the end of the law comes later.
TEST_P(ContactEnds, AfterItHasBegunToSlide) {
  for (const Hinge& hinge : hinges()) {
    SCOPED_TRACE(hinge.name);
    auto forces = std::make_shared<Pull>(
        [&](double time) { return rising(time) * law_end / hinge.share; },
        [&](double time) { return 400 / hinge.share * time; });
    Motion m = motion(hinge, forces, 0);
    EXPECT_EQ(m.advance_to(20), Stop::failed);
    ASSERT_EQ(m.changes().size(), 1u);
    EXPECT_EQ(m.changes()[0].to, HingeMode::sliding);
    EXPECT_LT(m.changes()[0].time, 2);
    expect_failure(m, hinge, 4.9, 5.25, rising);
  }
}

TEST_P(ContactEnds, WhereForcesJump) {
  const auto constant = [](double share) {
    return [share](double) { return share; };
  };
  for (const Hinge& hinge : hinges()) {
    // Held, and about to slide.
    for (const double torque : {50., 5000.}) {
      SCOPED_TRACE(fmt::format("{}, {} N m", hinge.name, torque));
      Motion m = motion(hinge, pull(hinge, constant(0.5), 50), 0);
      EXPECT_EQ(m.advance_to(1), Stop::time);
      m.set_forces(pull(hinge, constant(1.2), torque));
      expect_failure(m, hinge, 1, 1, constant(1.2));
      EXPECT_EQ(m.advance_to(2), Stop::failed);
      EXPECT_EQ(m.time(), 1);
      const Motion from_start =
          motion(hinge, pull(hinge, constant(1.2), torque), 0);
      expect_failure(from_start, hinge, 0, 0, constant(1.2));
    }
  }
}

// A lock needs no friction, and no contact is evaluated.
TEST_P(ContactEnds, WhenTheLockOpens) {
  for (const Hinge& hinge : hinges()) {
    SCOPED_TRACE(hinge.name);
    Motion m = motion(hinge, pull(hinge, rising, 50), 0, true);
    EXPECT_EQ(m.advance_to(8), Stop::time);
    const HingeSample sample = m.sample().hinge(0);
    EXPECT_EQ(sample.mode, HingeMode::locked);
    EXPECT_NEAR(sample.reaction_force.norm(), rising(8) * law_end / hinge.share,
                1e-6 * law_end);
    EXPECT_TRUE(sample.joints.empty());
    m.unlock(0);
    expect_failure(m, hinge, 8, 8, rising);
  }
}

// A trial state without rates ends no motion that never gets there.
TEST(AdaptiveStepper, TriesShorterStepsWhereThereAreNoRates) {
  double least = 1;
  const auto rates = [&](double, const double* y, double* to) {
    least = std::min(least, y[0]);
    to[0] = -y[0];
    return y[0] >= 0;
  };
  const auto stepper =
      multibody::make_adaptive_stepper({rates, rates}, {1e-9, 1e-10});
  stepper->set_next_step(10);
  stepper->restart(0, std::vector<double>{1});
  while (stepper->end() < 1) ASSERT_TRUE(stepper->step(10)) << stepper->end();
  EXPECT_NEAR(stepper->end_state()[0], std::exp(-stepper->end()), 1e-8);
  EXPECT_LT(least, 0);
}

INSTANTIATE_TEST_SUITE_P(Motion, ContactEnds,
                         testing::Values(Integrator::adaptive, Integrator::rk4),
                         [](const auto& tested) {
                           return tested.param == Integrator::rk4
                                      ? std::string("rk4")
                                      : std::string("adaptive");
                         });

}  // namespace
}  // namespace multibody::test::motion_contact_test
