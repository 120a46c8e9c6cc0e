#include "libcontact/joint/group.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <vector>

#include "support/accuracy_report.hpp"
#include "support/allocation_count.hpp"
#include "support/error_message.hpp"
#include "support/joints.hpp"
#include "support/numbers.hpp"
#include "support/random_slip.hpp"

namespace contact::test::group_test {
namespace {

using Member = JointGroup::Member;
using Solution = JointGroup::Solution;
using Sharing = JointGroup::Sharing;
using Eigen::Vector3d;

Member ball(double position, const FrictionModel& friction) {
  return {steel_ball(friction), position};
}
Member pin(double position, const FrictionModel& friction) {
  return {steel_pin(friction, JointBody::carrier, 0.08), position};
}

void solve(const JointGroup& group, const Vector3d& reaction,
           const Vector3d& moment, const Vector3d& axis,
           double angular_velocity, Solution& solution) {
  group.solve({.reaction = reaction,
               .moment = moment,
               .axis = axis,
               .angular_velocity = angular_velocity},
              solution);
}

// R and M of a group from its joints: the sums that they have to give.
struct Sums {
  Vector3d force = Vector3d::Zero();
  Vector3d moment = Vector3d::Zero();
  double friction = 0;
  double power = 0;

  Sums(const JointGroup& group, const Solution& solution,
       const Vector3d& axis) {
    for (std::size_t i = 0; i < group.joints().size(); ++i) {
      const JointSolution& s = solution.joints[i];
      force += s.reaction;
      moment += group.joints()[i].position * axis.cross(s.reaction) +
                s.friction_moment - s.friction_moment.dot(axis) * axis;
      friction += s.friction_moment.dot(axis);
      power += s.power;
    }
  }
};

TEST(JointGroup, BallAndPinReproduceTheirForceAndMoment) {
  RandomSlips random(1);
  AccuracyReport force("sum of forces over R", 1e-12);
  AccuracyReport moment("sum of moments over R x distance", 1e-12);
  int most_rounds = 0;
  for (int i = 0; i < 500; ++i) {
    const FrictionLaw friction(random.uniform(), random.log_uniform(1e3, 1e8));
    const double distance = random.log_uniform(0.2, 3);
    const JointGroup group(
        {ball(0, friction),
         pin(random.uniform() < 0.5 ? distance : -distance, friction)});
    const Vector3d axis = random.direction();
    const Vector3d reaction = random.log_uniform(1e3, 1e7) * random.direction();
    const Vector3d given = reaction.norm() * distance * random.direction();
    const Vector3d across = given - given.dot(axis) * axis;
    Solution solution = group.make_solution();
    const double rate = random.uniform() - 0.5;
    solve(group, reaction, given, axis, rate, solution);
    const std::string label = "input " + std::to_string(i);
    ASSERT_EQ(solution.status, Status::ok) << label;
    most_rounds = std::max(most_rounds, solution.iterations);
    const Sums sums(group, solution, axis);
    force.add_error((sums.force - reaction).norm() / reaction.norm(), label);
    moment.add_error(
        (sums.moment - across).norm() / (reaction.norm() * distance), label);
    EXPECT_DOUBLE_EQ(sums.friction, solution.friction_moment);
    EXPECT_DOUBLE_EQ(sums.power, solution.power);
    EXPECT_LT(solution.friction_moment * rate, 0);
    EXPECT_NEAR(solution.friction_moment * rate / solution.power, 1, 1e-12);
    // The pin takes nothing along the axis.
    EXPECT_LE(std::abs(solution.joints[1].reaction.dot(axis)),
              1e-15 * reaction.norm());
    // A start from another state gives the same.
    Solution again = solution;
    solve(group, 1.01 * reaction, given, axis, rate, again);
    solve(group, reaction, given, axis, rate, again);
    EXPECT_NEAR(again.friction_moment / solution.friction_moment, 1, 1e-11);
  }
  std::printf("most rounds %d\n", most_rounds);
}

// Without friction statics alone: R_2 = M x u / z_2.
TEST(JointGroup, LeverRule) {
  const JointGroup group({ball(0, FrictionLaw(0)), pin(2, FrictionLaw(0))});
  Solution s = group.make_solution();
  solve(group, {10, 0, 7}, {0, 6, 0}, {0, 0, 1}, 1, s);
  EXPECT_LE((s.joints[0].reaction - Vector3d(7, 0, 7)).norm(), 1e-14);
  EXPECT_LE((s.joints[1].reaction - Vector3d(3, 0, 0)).norm(), 1e-14);
  EXPECT_EQ(s.friction_moment, 0);
}

// Two equal balls with a symmetric load: each as if it were alone.
TEST(JointGroup, TwoBallsShare) {
  const FrictionLaw friction(0.25, 2.5e8);
  const std::vector<Member> joints = {ball(-0.5, friction),
                                      ball(0.5, friction)};
  const JointGroup group(joints, Sharing::equal(joints));
  const Vector3d reaction(1.122e6, 3.23e5, 0);
  const Vector3d axis(0, 0, 1);
  Solution s = group.make_solution();
  solve(group, 2 * reaction, Vector3d::Zero(), axis, 0.1, s);
  ASSERT_EQ(s.status, Status::ok);
  const Joint& alone = joints[0].joint;
  const JointSolution one = alone.solve({reaction, 0.1 * axis});
  EXPECT_NEAR(s.friction_moment / (2 * one.friction_moment.z()), 1, 1e-13);
  // Unequal springs and axial shares.
  const JointGroup uneven(joints, Sharing{{1, 3}, {0.2, 0.8}});
  Solution t = uneven.make_solution();
  const Vector3d oblique(2e5, 0, 1e5);
  solve(uneven, oblique, Vector3d::Zero(), axis, 0, t);
  EXPECT_NEAR(t.joints[0].reaction.z(), 0.2e5, 1e-9);
  EXPECT_NEAR(t.joints[1].reaction.z(), 0.8e5, 1e-9);
  // Determinate across the axis: stiffness has no influence.
  EXPECT_NEAR(t.joints[0].reaction.x(), 1e5, 1e-9);
}

// Three supports under a rigid axis: the springs' reactions.
TEST(JointGroup, ThreeSupportsFollowTheirStiffness) {
  const FrictionLaw none(0);
  const std::vector<Member> joints = {ball(-1, none), pin(0, none),
                                      pin(2, none)};
  const JointGroup group(joints, Sharing{{2, 1, 3}, {1, 0, 0}});
  Solution s = group.make_solution();
  // shift 5, tilt 2 of an axis along z, forces along x: k (5 + 2 z).
  const double forces[] = {2 * 3.0, 1 * 5.0, 3 * 9.0};
  const Vector3d reaction(6 + 5 + 27, 0, 0);
  const Vector3d moment(0, -6 + 0 + 54, 0);
  solve(group, reaction, moment, {0, 0, 1}, 0, s);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(s.joints[i].reaction.x(), forces[i], 1e-13) << i;
  }
}

TEST(JointGroup, RestAndUtilisation) {
  const FrictionLaw friction(0.2, 1e7);
  const JointGroup group({ball(0, friction), pin(1, friction)});
  const Vector3d reaction(1e5, 2e4, 3e4);
  const Vector3d moment(4e4, -1e4, 0);
  const Vector3d axis(0, 0, 1);
  Solution s = group.make_solution();
  solve(group, reaction, moment, axis, 0, s);
  EXPECT_EQ(s.status, Status::ok);
  EXPECT_EQ(s.friction_moment, 0);
  EXPECT_EQ(s.joints[0].state, JointState::resting);
  Solution slide = group.make_solution();
  solve(group, reaction, moment, axis, -1e-6, slide);
  EXPECT_NEAR(group.utilisation({.reaction = reaction,
                                 .moment = moment,
                                 .axis = axis,
                                 .needed = 0.3 * slide.friction_moment},
                                s),
              0.3, 1e-12);
  EXPECT_EQ(
      group.utilisation(
          {.reaction = reaction, .moment = moment, .axis = axis, .needed = 0},
          s),
      0);
}

TEST(JointGroup, ViscousJointsGoThroughTheSameNode) {
  const ViscousLaw oil(1e6, 0.1);
  const JointGroup group({ball(0, oil), pin(1, oil)});
  Solution s = group.make_solution();
  const Vector3d axis(0, 0, 1);
  solve(group, {1e5, 0, 0}, {0, 4e4, 0}, axis, 1, s);
  ASSERT_EQ(s.status, Status::ok);
  const double fast = s.friction_moment;
  solve(group, {1e5, 0, 0}, {0, 4e4, 0}, axis, 1e-6, s);
  // Linear in the rate while friction does not move the contact.
  EXPECT_NEAR(s.friction_moment / (1e-6 * fast), 1, 0.02);
  EXPECT_EQ(group.utilisation({.reaction = {1e5, 0, 0},
                               .moment = {0, 4e4, 0},
                               .axis = axis,
                               .needed = 1},
                              s),
            infinity);
}

TEST(JointGroup, RefusesWhatStaticsDoesNotSettle) {
  const FrictionLaw f(0.1);
  const auto message = [](std::vector<Member> joints,
                          std::optional<Sharing> rule = {}) {
    return error_message([&] { JointGroup(joints, rule); });
  };
  EXPECT_EQ(
      message({ball(0, f)}),
      "joint group of 1 joint requires at least 2, to hold moments across "
      "the axis");
  EXPECT_EQ(
      message({pin(0, f), pin(1, f)}),
      "joint group requires a ball joint or a thrust_face, to take the force "
      "along the axis");
  EXPECT_EQ(message({ball(1, f), pin(1, f)}),
            "joint group: duplicate position 1 m");
  EXPECT_EQ(message({ball(0, f), pin(nan, f)}),
            "joint group: position = nan must be finite");
  EXPECT_EQ(
      message({ball(0, f), pin(1, f), pin(2, f)}),
      "joint group of 3 joints requires a sharing rule: more than 2 share "
      "the force across the axis, statically indeterminate");
  EXPECT_EQ(message({ball(0, f), ball(1, f)}),
            "joint group of 2 ball joints requires a sharing rule: more than 1 "
            "shares the force along the axis, statically indeterminate");
  EXPECT_EQ(
      message({ball(0, f), ball(1, f)}, Sharing{{1}, {1, 0}}),
      "joint group: sharing rule for 1 and 2 joints requires one value for "
      "each of the 2 joints");
  EXPECT_EQ(message({ball(0, f), pin(1, f)}, Sharing{{1, 1}, {0.5, 0.5}}),
            "joint group: axial_share = 0.5 must be 0 for a pin");
  EXPECT_EQ(message({ball(0, f), ball(1, f)}, Sharing{{1, 0}, {1, 0}}),
            "joint group: radial_stiffness = 0 must be above 0 and finite");
  EXPECT_EQ(message({ball(0, f), ball(1, f)}, Sharing{{1, 1}, {1, 1}}),
            "joint group: sum of axial_share = 2 must be 1");
}

TEST(JointGroup, NanGivesStatusAndNothingAllocates) {
  const FrictionLaw friction(0.2, 1e7);
  const JointGroup group({ball(0, friction), pin(1, friction)});
  Solution s = group.make_solution();
  const std::size_t before = allocation_count();
  solve(group, {nan, 0, 0}, {0, 0, 0}, {0, 0, 1}, 1, s);
  EXPECT_EQ(s.status, Status::out_of_range);
  EXPECT_TRUE(std::isnan(s.friction_moment));
  // And recovers.
  solve(group, {1e4, 0, 0}, {0, 0, 0}, {0, 0, 1}, 1, s);
  EXPECT_EQ(s.status, Status::ok);
  EXPECT_LT(s.friction_moment, 0);
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace contact::test::group_test
