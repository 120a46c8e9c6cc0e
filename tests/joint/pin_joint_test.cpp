
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <vector>

#include "libcontact/joint/fixed_point.hpp"
#include "support/accuracy_report.hpp"
#include "support/allocation_count.hpp"
#include "support/joints.hpp"
#include "support/numbers.hpp"
#include "support/random_slip.hpp"

namespace contact::test::pin_joint_test {
namespace {

using Eigen::Vector3d;

constexpr double rho = 0.04;
constexpr double length = 0.1;

// The closed forms at a known R_n, written out for the cosine pressure.
struct ClosedForm {
  double f;
  double moment;

  ClosedForm(const Joint& joint, double f0, double adhesion, double force) {
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
  AccuracyReport coefficient("M_t/(rho R)", 1e-14);  // some roundings
  for (int i = 0; i < 2000; ++i) {
    const double f0 = random.uniform() < 0.1 ? 0 : 5 * random.uniform();
    const double adhesion =
        random.uniform() < 0.2 ? 0 : random.log_uniform(1e3, 1e10);
    const JointBody inner =
        random.uniform() < 0.5 ? JointBody::carrier : JointBody::body;
    const Joint joint = steel_pin(FrictionLaw(f0, adhesion), inner);
    const Vector3d axis = random.direction();
    const Vector3d reaction = random.log_uniform(1e3, 1e8) * random.direction();
    const double rate = random.uniform() - 0.5;
    const JointSolution s = joint.solve({reaction, rate * axis, axis});
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
    coefficient.add(s.moment_coefficient(),
                    s.friction_moment.norm() / s.reaction.norm() /
                        joint.contact().geometry().radius(),
                    label);
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
    const JointSolution warm =
        joint.solve({1.001 * reaction, rate * axis, axis}, s);
    ASSERT_EQ(warm.status, Status::ok) << label;
    residual.add_error(
        std::abs(ClosedForm(joint, f0, adhesion, warm.normal_force).f /
                     warm.force_coefficient -
                 1),
        label + " moved");
  }
}

// Without adhesion tan g = f0, and as theta0 -> 0 the moment is rho R_t.
TEST(PinJoint, CoulombsLimit) {
  for (const double f0 : {1e-3, 0.2, 3.0}) {
    const Joint joint = steel_pin(FrictionLaw(f0));
    for (const double force : {1e-4, 1e5}) {
      const JointSolution s = joint.solve({{force, 0, 0}, {0, 0, 1}});
      EXPECT_NEAR(s.force_coefficient / f0, 1, 1e-15);
      EXPECT_NEAR(s.normal_force * std::sqrt(1 + f0 * f0) / force, 1, 1e-15);
    }
    const JointSolution s = joint.solve({{1e-4, 0, 0}, {0, 0, 1}});
    // theta0 = 4e-6 here, and S = 1 + O(theta0^2).
    EXPECT_NEAR(-s.friction_moment.z() / (rho * s.friction_force.norm()), 1,
                1e-10);
  }
}

TEST(PinJoint, ViscousGrowsWithTheRate) {
  const Joint joint = steel_pin(ViscousLaw(2e6, 0.3));
  const Vector3d reaction(2e4, 0, 0);
  const Vector3d axis(0, 0, 1);
  for (const double rate : {1e-9, 1e-3, 1.0, 50.0}) {
    const JointSolution s = joint.solve({reaction, rate * axis});
    const ClosedForm expected(joint, 0.3 * rho * rate, 2e6 * rho * rate,
                              s.normal_force);
    EXPECT_NEAR(expected.f / s.force_coefficient, 1, 2e-13);
    EXPECT_NEAR(-s.friction_moment.z() / expected.moment, 1, 1e-12);
  }
  // It holds nothing.
  EXPECT_EQ(joint.at_rest({reaction, axis}).utilisation, infinity);
  EXPECT_EQ(joint.at_rest({reaction, Vector3d::Zero(), axis}).utilisation, 0);
}

TEST(PinJoint, HoldsAtRestWhatItHasWhenSliding) {
  const Joint joint = steel_pin(FrictionLaw(0.3, 1e8));
  const Vector3d reaction(2e4, 3e4, 0);
  const Vector3d axis(0, 0, 1);
  const RestSolution one = joint.at_rest({reaction, axis});
  const double limit = one.slip.friction_moment.z();
  EXPECT_EQ(one.utilisation, 1 / limit);
  EXPECT_EQ(one.direction, -axis);
  EXPECT_EQ(limit, -joint.solve({reaction, 1e-9 * axis}).friction_moment.z());
  EXPECT_EQ(joint.at_rest({reaction, 0.5 * limit * axis}).utilisation, 0.5);
  EXPECT_EQ(joint.at_rest({reaction, -2 * limit * axis}).utilisation, 2);
  for (const double sign : {1.0, -1.0}) {
    EXPECT_EQ(joint.at_rest({Vector3d::Zero(), sign * axis}).utilisation,
              infinity);
  }
  EXPECT_EQ(joint.solve({reaction, 0 * axis}).state, JointState::resting);
  EXPECT_EQ(joint.solve({{0, 0, 5}, axis}).state, JointState::unloaded);
}

TEST(PinJoint, FixedPointAgrees) {
  const Joint joint = steel_pin(FrictionLaw(0.2, 2e7));
  const Vector3d reaction(1e6, 0, 0);
  std::vector<FixedPointStep> trace(200);
  const auto result = contact::fixed_point(joint, {reaction, {0, 0, 1}}, trace,
                                           {.tolerance = 1e-14});
  ASSERT_EQ(result.status, Status::ok);
  EXPECT_EQ(trace[0].friction_angle, 0);
  EXPECT_NEAR(trace[0].slip_axis_angle, 0, 1e-16);
  const JointSolution s = joint.solve({reaction, {0, 0, 1}});
  EXPECT_NEAR(trace[result.steps - 1].normal_force / s.normal_force, 1, 1e-13);
}

TEST(PinJoint, NanGivesNanAndNothingAllocates) {
  const Joint joint = steel_pin(FrictionLaw(0.3, 1e8));
  const std::size_t before = allocation_count();
  for (const double bad : {nan, infinity}) {
    for (const JointSolution& s :
         {joint.solve({{bad, 0, 0}, {0, 0, 1}}),
          joint.solve({{1, 0, 0}, {0, 0, bad}}),
          joint.solve({{1, 0, 0}, {0, 0, bad}, {0, 0, 1}}),
          joint.solve_contact({{1, 0, bad}, {0, 0, 1}})}) {
      EXPECT_EQ(s.status, Status::out_of_range);
      EXPECT_TRUE(std::isnan(s.normal_force));
    }
  }
  for (const RestSolution& rest :
       {joint.at_rest({{nan, 0, 0}, {0, 0, 1}}),
        joint.at_rest({{nan, 0, 0}, {0, 0, 0}}),
        joint.at_rest({{1e4, 0, 0}, {0, 0, nan}, {0, 0, 1}})}) {
    EXPECT_EQ(rest.status, Status::out_of_range);
    EXPECT_TRUE(std::isnan(rest.utilisation));
    EXPECT_TRUE(rest.direction.hasNaN());
  }
  const JointSolution s = joint.solve({{1e4, 0, 0}, {0, 0, 1}});
  joint.solve({{1e4, 1, 0}, {0, 0, 1}}, s);
  EXPECT_EQ(allocation_count(), before);
}

// With no axis, the direction of Dw or M is the pin's.
TEST(PinJoint, AxisIsTheGivenOneOrThatOfTheTurn) {
  const Joint joint = steel_pin(FrictionLaw(0.3, 1e8));
  const Vector3d reaction(2e4, 3e4, 1e4);
  const Vector3d axis = Vector3d(1, 2, -2) / 3;
  const Vector3d radial = reaction - reaction.dot(axis) * axis;
  const JointSolution given = joint.solve({reaction, 0.6 * axis, axis});
  const JointSolution found = joint.solve({reaction, 0.6 * axis});
  EXPECT_TRUE(given.reaction.isApprox(radial, 1e-15));
  EXPECT_TRUE(found.reaction.isApprox(radial, 1e-15));
  EXPECT_TRUE(found.friction_moment.isApprox(given.friction_moment, 1e-14));
  const JointSolution contact = joint.solve_contact({reaction, 0.6 * axis});
  EXPECT_NEAR(contact.normal_force / radial.norm(), 1, 1e-15);
  // Rest has none of its own.
  EXPECT_TRUE(joint.solve({reaction, Vector3d::Zero(), axis})
                  .reaction.isApprox(radial, 1e-15));
  EXPECT_EQ(joint.solve({reaction, Vector3d::Zero()}).reaction, reaction);
  // Only the part of a moment about a given axis counts.
  const Vector3d across = axis.unitOrthogonal();
  EXPECT_NEAR(
      joint.at_rest({reaction, 7 * axis + 5 * across, axis}).utilisation /
          joint.at_rest({reaction, 7 * axis}).utilisation,
      1, 1e-14);
}

}  // namespace
}  // namespace contact::test::pin_joint_test
