#include "multibody/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "libcontact/error.hpp"
#include "multibody_support/friction_parts.hpp"
#include "multibody_support/random_instant.hpp"

// Motions against closed forms: friction stops and holds, sliding begins where
// it should, energies and momenta add up.
namespace {

using contact::FrictionLaw;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using multibody::BallFriction;
using multibody::BodyForce;
using multibody::BodyMotion;
using multibody::Carrier;
using multibody::CarrierDrive;
using multibody::ForceModel;
using multibody::HingeFriction;
using multibody::HingeMode;
using multibody::HingeSample;
using multibody::Integrator;
using multibody::JointKind;
using multibody::Load;
using multibody::LoadStart;
using multibody::Motion;
using multibody::MotionOptions;
using multibody::MotionStart;
using multibody::NodeFriction;
using multibody::PinFriction;
using multibody::Stop;
using multibody::System;
using multibody::test::ball_and_pin;
using multibody::test::ball_joint;
using multibody::test::pin_joint;

constexpr double g = 9.81;

Carrier heavy_carrier() { return {100, 50 * Matrix3d::Identity()}; }

// A wheel on a horizontal axis through its centre of mass; about the axis
// (z) its inertia is `about`.
Load wheel(double mass, double about) {
  Load load{JointKind::axis, mass, Matrix3d::Zero()};
  load.inertia.diagonal() << 0.7 * about, 0.7 * about, about;
  return load;
}

MotionStart start_of(int loads) {
  MotionStart start;
  start.loads.resize(loads);
  return start;
}

MotionOptions on_fixed_carrier() {
  MotionOptions options;
  options.carrier_drive = CarrierDrive{};
  options.gravity = Vector3d(0, -g, 0);
  return options;
}

// A torque about z on load 0, as a function of time.
class Torque : public ForceModel {
 public:
  explicit Torque(std::function<double(double)> torque)
      : torque_(std::move(torque)) {}
  void add_forces(double time, std::span<const BodyMotion>,
                  std::span<BodyForce> forces) const override {
    forces[1].moment.z() += torque_(time);
  }

 private:
  std::function<double(double)> torque_;
};

TEST(Motion, ConstantFrictionStopsAWheelAndItStays) {
  const double mass = 20, about = 0.4, w0 = 3;
  const auto joint = pin_joint(FrictionLaw(0.2, 1e4));
  const double friction =
      joint.moment_limit(Vector3d(0, mass * g, 0), Vector3d::UnitZ());
  ASSERT_GT(friction, 0);
  for (const Integrator integrator : {Integrator::adaptive, Integrator::rk4}) {
    for (const double sign : {1.0, -1.0}) {
      MotionOptions options = on_fixed_carrier();
      options.integrator = integrator;
      options.step = 0.01;
      MotionStart start = start_of(1);
      start.loads[0].angle_rate = sign * w0;
      Motion motion(System(heavy_carrier(), {wheel(mass, about)}),
                    {PinFriction{joint}}, nullptr, start, options);
      const double stop = about * w0 / friction;
      EXPECT_EQ(motion.sample().mode(0), HingeMode::sliding);
      ASSERT_EQ(motion.advance_to(stop + 5), Stop::time);
      ASSERT_EQ(motion.changes().size(), 1u);
      EXPECT_EQ(motion.changes()[0].to, HingeMode::resting);
      EXPECT_NEAR(motion.changes()[0].time, stop, 1e-9 * stop);
      const HingeSample hinge = motion.sample().hinge(0);
      EXPECT_EQ(hinge.angle_rate, 0);
      EXPECT_NEAR(hinge.angle, sign * w0 * stop / 2, 1e-9 * w0 * stop);
      EXPECT_NEAR(hinge.dissipated, about * w0 * w0 / 2,
                  1e-9 * about * w0 * w0);
      EXPECT_LT(motion.counts().steps, 5000);
    }
  }
}

TEST(Motion, RampedTorqueStartsSlidingAtTheRightInstant) {
  const double mass = 20, about = 0.4, slope = 1.7;
  const auto joint = pin_joint(FrictionLaw(0.2, 1e4));
  const double friction =
      joint.moment_limit(Vector3d(0, mass * g, 0), Vector3d::UnitZ());
  for (const Integrator integrator : {Integrator::adaptive, Integrator::rk4}) {
    MotionOptions options = on_fixed_carrier();
    options.integrator = integrator;
    options.step = 0.01;
    const auto torque =
        std::make_shared<Torque>([=](double t) { return slope * t; });
    Motion motion(System(heavy_carrier(), {wheel(mass, about)}),
                  {PinFriction{joint}}, torque, start_of(1), options);
    const double begin = friction / slope;
    EXPECT_EQ(motion.sample().mode(0), HingeMode::resting);
    ASSERT_EQ(motion.advance_to(begin + 2), Stop::time);
    ASSERT_EQ(motion.changes().size(), 1u);
    EXPECT_EQ(motion.changes()[0].to, HingeMode::sliding);
    EXPECT_NEAR(motion.changes()[0].time, begin, 1e-9 * begin);
    // I w = slope (t - begin)^2/2
    EXPECT_NEAR(motion.sample().hinge(0).angle_rate, slope * 2 / about,
                1e-8 * slope * 2 / about);
  }
}

// A small ball under a heavy load has a wide contact; a large one under a
// light load a point-like one, which resists spinning so little that sliding
// dies out long before it.
struct BallCase {
  double mass;
  double radius;
  Integrator integrator;
  long most_evaluations;  // some twice what it takes
};

TEST(Motion, BallJointStopsInFiniteTimeWithBoundedWork) {
  const BallCase cases[] = {{2000, 0.005, Integrator::adaptive, 2000},
                            {2000, 0.005, Integrator::rk4, 100000},
                            {20, 0.05, Integrator::adaptive, 20000}};
  for (const BallCase& c : cases) {
    Load load{JointKind::spherical, c.mass, Matrix3d::Zero()};
    load.inertia.diagonal() << 3, 4, 5;
    MotionStart start = start_of(1);
    start.loads[0].relative_angular_velocity = Vector3d(1, 2, -1.5);
    MotionOptions options = on_fixed_carrier();
    options.integrator = c.integrator;
    options.step = 1e-3;
    Motion motion(System(heavy_carrier(), {load}),
                  {BallFriction{ball_joint(FrictionLaw(0.2, 1e4), c.radius)}},
                  nullptr, start, options);
    const double before = motion.sample().energy().balance();
    ASSERT_EQ(motion.advance_to(200), Stop::time);
    ASSERT_EQ(motion.changes().size(), 1u);
    const HingeSample hinge = motion.sample().hinge(0);
    EXPECT_EQ(hinge.mode, HingeMode::resting);
    EXPECT_EQ(hinge.relative_angular_velocity.norm(), 0);
    EXPECT_NEAR(motion.sample().energy().balance(), before, 1e-8 * before);
    std::printf("stopped at %.12g s: %ld evaluations, %ld steps, %ld outer\n",
                motion.changes()[0].time, motion.counts().evaluations,
                motion.counts().steps, motion.counts().outer_iterations);
    if (c.integrator == Integrator::adaptive) {
      EXPECT_LT(motion.counts().evaluations, c.most_evaluations);
    }
  }
}

}  // namespace
