#include "libcontact/joint/pin_joint.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "libcontact/half_angle/factory.hpp"
#include "libcontact/pressure/cosine.hpp"
#include "support/accuracy_report.hpp"
#include "support/allocation_count.hpp"
#include "support/error_message.hpp"
#include "support/random_slip.hpp"

namespace {

using contact::ElasticPair;
using contact::FixedPointStep;
using contact::FrictionLaw;
using contact::FrictionModel;
using contact::JointBody;
using contact::JointGeometry;
using contact::JointKind;
using contact::JointSolution;
using contact::JointState;
using contact::PinJoint;
using contact::Status;
using contact::ViscousLaw;
using contact::test::AccuracyReport;
using contact::test::RandomSlips;
using Eigen::Vector3d;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rho = 0.04;
constexpr double length = 0.1;

PinJoint steel_pin(const FrictionModel& friction,
                   JointBody inner = JointBody::carrier) {
  const ElasticPair pair({2e11, 0.3}, {2e11, 0.3});
  return {JointGeometry::pin(rho, 4e-5, length, inner), pair, friction,
          contact::make_half_angle_law("blend", JointKind::pin, pair),
          std::make_unique<contact::CosinePressure>(JointKind::pin)};
}

// The closed forms at a known R_n, written out for the cosine pressure.
struct ClosedForm {
  double f;
  double moment;

  ClosedForm(const PinJoint& joint, double f0, double adhesion, double force) {
    const double t = joint.contact().half_angle(force).half_angle;
    const double s = std::sin(t);
    const double c = std::cos(t);
    f = f0 + 2 * adhesion * rho * length * s / force;
    moment = rho * (f0 * force * (2 * s - 2 * t * c) / (t - s * c) +
                    2 * adhesion * rho * length * t);
  }
};

TEST(PinJoint, SolvesItsClosedForms) {
  RandomSlips random(1);
  AccuracyReport residual("f/tan g - 1", 2e-13);
  // (s - t c)/(t - s c) cancels at small t: loads that keep t above 0.1.
  AccuracyReport moment("M_t about the axis", 1e-12);
  // Taking the part of R normal to the axis cancels where R is nearly along
  // it: some roundings over its sine, 0.03 at least here.
  AccuracyReport directions("R, n, R_t, axis", 3e-14);
  for (int i = 0; i < 2000; ++i) {
    const double f0 = random.uniform() < 0.1 ? 0 : 5 * random.uniform();
    const double adhesion =
        random.uniform() < 0.2 ? 0 : random.log_uniform(1e3, 1e10);
    const JointBody inner =
        random.uniform() < 0.5 ? JointBody::carrier : JointBody::body;
    const PinJoint joint = steel_pin(FrictionLaw(f0, adhesion), inner);
    const Vector3d axis = random.direction();
    const Vector3d reaction = random.log_uniform(1e3, 1e8) * random.direction();
    const double rate = random.uniform() - 0.5;
    const JointSolution s = joint.solve(reaction, axis, rate);
    const std::string label = "input " + std::to_string(i);
    ASSERT_EQ(s.status, Status::ok) << label;
    if (f0 == 0 && adhesion == 0) {
      EXPECT_EQ(s.friction_moment.norm(), 0);
      continue;
    }
    const ClosedForm expected(joint, f0, adhesion, s.normal_force);
    residual.add_error(std::abs(expected.f / s.force_coefficient - 1), label);
    if (s.half_angle > 0.1) {
      moment.add(-s.friction_moment.dot(axis),
                 std::copysign(expected.moment, rate), label);
    }
    const Vector3d radial = reaction - reaction.dot(axis) * axis;
    directions.add_error((s.reaction - radial).norm() / radial.norm(), label);
    directions.add_error(
        (s.normal_force * s.normal + s.friction_force - radial).norm() /
            radial.norm(),
        label);
    directions.add_error(
        s.friction_moment.cross(axis).norm() / s.friction_moment.norm(), label);
    EXPECT_LT(s.power, 0) << label;
    EXPECT_LT(s.friction_force.dot(s.slip_velocity), 0) << label;
    const JointSolution warm = joint.solve(1.001 * reaction, axis, rate, s);
    ASSERT_EQ(warm.status, Status::ok) << label;
    residual.add_error(
        std::abs(ClosedForm(joint, f0, adhesion, warm.normal_force).f /
                     warm.force_coefficient -
                 1),
        label + " moved");
  }
  residual.check();
  moment.check();
  directions.check();
}

// Without adhesion tan g = f0, and as theta0 -> 0 the moment is rho R_t.
TEST(PinJoint, CoulombsLimit) {
  for (const double f0 : {1e-3, 0.2, 3.0}) {
    const PinJoint joint = steel_pin(FrictionLaw(f0));
    for (const double force : {1e-4, 1e5}) {
      const JointSolution s = joint.solve({force, 0, 0}, {0, 0, 1}, 1);
      EXPECT_NEAR(s.force_coefficient / f0, 1, 1e-15);
      EXPECT_NEAR(s.normal_force * std::sqrt(1 + f0 * f0) / force, 1, 1e-15);
    }
    const JointSolution s = joint.solve({1e-4, 0, 0}, {0, 0, 1}, 1);
    // theta0 = 4e-6 here, and S = 1 + O(theta0^2).
    EXPECT_NEAR(-s.friction_moment.z() / (rho * s.friction_force.norm()), 1,
                1e-10);
  }
}

TEST(PinJoint, ViscousGrowsWithTheRate) {
  const PinJoint joint = steel_pin(ViscousLaw(2e6, 0.3));
  const Vector3d reaction(2e4, 0, 0);
  const Vector3d axis(0, 0, 1);
  for (const double rate : {1e-9, 1e-3, 1.0, 50.0}) {
    const JointSolution s = joint.solve(reaction, axis, rate);
    const ClosedForm expected(joint, 0.3 * rho * rate, 2e6 * rho * rate,
                              s.normal_force);
    EXPECT_NEAR(expected.f / s.force_coefficient, 1, 2e-13);
    EXPECT_NEAR(-s.friction_moment.z() / expected.moment, 1, 1e-12);
  }
  EXPECT_EQ(joint.moment_limit(reaction, axis), 0);
  EXPECT_EQ(joint.utilisation(reaction, axis, 1), infinity);
  EXPECT_EQ(joint.utilisation(reaction, axis, 0), 0);
}

TEST(PinJoint, HoldsAtRestWhatItHasWhenSliding) {
  const PinJoint joint = steel_pin(FrictionLaw(0.3, 1e8));
  const Vector3d reaction(2e4, 3e4, 0);
  const Vector3d axis(0, 0, 1);
  const double limit = joint.moment_limit(reaction, axis);
  EXPECT_EQ(limit, -joint.solve(reaction, axis, 1e-9).friction_moment.z());
  EXPECT_EQ(joint.utilisation(reaction, axis, 0.5 * limit), 0.5);
  EXPECT_EQ(joint.utilisation(reaction, axis, -2 * limit), 2);
  EXPECT_EQ(joint.solve(reaction, axis, 0).state, JointState::resting);
  EXPECT_EQ(joint.solve({0, 0, 5}, axis, 1).state, JointState::unloaded);
}

TEST(PinJoint, FixedPointAgrees) {
  const PinJoint joint = steel_pin(FrictionLaw(0.2, 2e7));
  const Vector3d reaction(1e6, 0, 0);
  std::vector<FixedPointStep> trace(200);
  const auto result = joint.fixed_point(reaction, {0, 0, 1}, 1, trace, 1e-14);
  ASSERT_EQ(result.status, Status::ok);
  EXPECT_EQ(trace[0].friction_angle, 0);
  EXPECT_NEAR(trace[0].slip_axis_angle, 0, 1e-16);
  const JointSolution s = joint.solve(reaction, {0, 0, 1}, 1);
  EXPECT_NEAR(trace[result.steps - 1].normal_force / s.normal_force, 1, 1e-13);
}

TEST(PinJoint, NanGivesNanAndNothingAllocates) {
  const PinJoint joint = steel_pin(FrictionLaw(0.3, 1e8));
  const std::size_t before = contact::test::allocation_count();
  for (const double bad : {nan, infinity}) {
    for (const JointSolution& s :
         {joint.solve({bad, 0, 0}, {0, 0, 1}, 1),
          joint.solve({1, 0, 0}, {0, 0, 1}, bad),
          joint.solve_contact({1, 0, bad}, {0, 0, 1}, 1)}) {
      EXPECT_EQ(s.status, Status::out_of_range);
      EXPECT_TRUE(std::isnan(s.normal_force));
    }
  }
  EXPECT_TRUE(std::isnan(joint.utilisation({nan, 0, 0}, {0, 0, 1}, 1)));
  const JointSolution s = joint.solve({1e4, 0, 0}, {0, 0, 1}, 1);
  joint.solve({1e4, 1, 0}, {0, 0, 1}, 1, s);
  EXPECT_EQ(contact::test::allocation_count(), before);
}

TEST(PinJoint, RefusesABall) {
  const ElasticPair pair({2e11, 0.3}, {2e11, 0.3});
  EXPECT_EQ(contact::test::error_message([&] {
              PinJoint(
                  JointGeometry::ball(0.05, 5e-5), pair, FrictionLaw(0.1),
                  contact::make_half_angle_law("tanh", JointKind::ball, pair),
                  std::make_unique<contact::CosinePressure>(JointKind::ball));
            }),
            "pin joint: geometry of a ball joint must be of a pin joint");
}

}  // namespace
