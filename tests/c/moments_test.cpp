// Moment sets and derivatives from C are bit-identical to C++.
#include "libcontact/c/moments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "c/door.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/joint/derivatives.hpp"

namespace contact::test::moments_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const std::string ball_file = CONTACT_DATA_DIR "/joints/hip_cocr_uhmwpe.toml";
const std::string pin_file = CONTACT_DATA_DIR "/joints/pin_joint.toml";
constexpr contact_slip slip = {{0, 100, 1000}, {1, 0.5, 0.2}, {}};
const Joint::Slip cpp_slip = {Vector3d(slip.reaction),
                              Vector3d(slip.angular_velocity)};

contact_solution solved(const contact_joint* joint) {
  contact_solution s;
  EXPECT_EQ(contact_joint_solve(joint, &slip, nullptr, &s), CONTACT_OK);
  return s;
}

TEST(CMoments, OfASetAreThoseOfCpp) {
  const CJoint ball = c_joint(ball_file);
  const contact_solution s = solved(ball.get());
  const Joint cpp(read_joint(ball_file));
  const JointSolution cpp_solution = cpp.solve(cpp_slip);
  const MomentSet set = cpp.moment_set(cpp_solution);
  contact_edge edge;
  ASSERT_EQ(contact_joint_edge(ball.get(), &s, slip.angular_velocity, &edge),
            CONTACT_OK);
  EXPECT_EQ(edge.power, set.support(cpp_slip.angular_velocity));
  EXPECT_EQ(Vector3d(edge.moment), set.moment(cpp_slip.angular_velocity));
  const double moment[3] = {0.1, 0.3, -0.02};
  contact_held held;
  ASSERT_EQ(contact_joint_held(ball.get(), &s, moment, &held), CONTACT_OK);
  EXPECT_EQ(held.utilisation, set.utilisation(Vector3d(moment)));
  EXPECT_EQ(Vector3d(held.nearest), set.project(Vector3d(moment)));
  const double inertia[9] = {2, 0.1, 0, 0.1, 3, 0, 0, 0, 1};
  for (const double size : {1e-3, 10.0}) {  // holds, slides
    const Vector3d free = size * Vector3d(1, 2, 3);
    contact_prox prox;
    ASSERT_EQ(contact_joint_prox(ball.get(), &s, inertia, free.data(), &prox),
              CONTACT_OK);
    const MomentSet::Prox p = set.prox(Matrix3d(inertia), free);
    EXPECT_EQ(Vector3d(prox.angular_velocity), p.angular_velocity);
    EXPECT_EQ(Vector3d(prox.moment), p.moment);
    EXPECT_EQ(prox.iterations, p.iterations);
    EXPECT_EQ(prox.residual, p.residual);
    EXPECT_EQ(p.angular_velocity.isZero(0), size < 1);
  }
}

TEST(CMoments, DerivativesAreThoseOfCppRowByRow) {
  for (const std::string& file : {ball_file, pin_file}) {
    const CJoint joint = c_joint(file);
    const contact_solution s = solved(joint.get());
    const Joint cpp(read_joint(file));
    const SlipDerivatives wanted =
        derivatives(cpp, cpp_slip, cpp.solve(cpp_slip));
    contact_derivatives d;
    ASSERT_EQ(contact_joint_derivatives(joint.get(), &slip, &s, &d),
              CONTACT_OK);
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(d.over_rate[3 * i + k], wanted.over_rate(i, k));
        EXPECT_EQ(d.over_reaction[3 * i + k], wanted.over_reaction(i, k));
        EXPECT_EQ(d.at_contact[3 * i + k], wanted.at_contact(i, k));
      }
    }
  }
}

TEST(CMoments, SayWhichArgumentIsWrong) {
  const CJoint ball = c_joint(ball_file);
  const CJoint pin = c_joint(pin_file);
  const contact_solution s = solved(ball.get());
  const double zero[3] = {0, 0, 0};
  const double wrong[3] = {0, std::numeric_limits<double>::quiet_NaN(), 0};
  contact_edge edge;
  contact_held held;
  contact_prox prox;
  contact_derivatives d;
  expect_failure(contact_joint_edge(ball.get(), &s, zero, &edge),
                 CONTACT_OUT_OF_RANGE,
                 "contact_joint_edge: angular_velocity must be finite and not "
                 "0, with friction that does not fall with the speed");
  expect_failure(contact_joint_held(ball.get(), &s, wrong, &held),
                 CONTACT_OUT_OF_RANGE,
                 "contact_joint_held: moment must be finite, with friction "
                 "that does not fall with the speed");
  expect_failure(contact_joint_held(pin.get(), &s, zero, &held),
                 CONTACT_BAD_INPUT,
                 "contact_joint_held: joint must be a ball joint");
  EXPECT_TRUE(std::isnan(held.utilisation));
  expect_failure(contact_joint_prox(ball.get(), &s, nullptr, zero, &prox),
                 CONTACT_BAD_INPUT,
                 "contact_joint_prox: inertia must be other than NULL");
  EXPECT_EQ(prox.status, CONTACT_BAD_INPUT);
  EXPECT_TRUE(std::isnan(prox.moment[2]));
  contact_slip resting = slip;
  for (double& x : resting.angular_velocity) x = 0;
  contact_solution at_rest;
  ASSERT_EQ(contact_joint_solve(ball.get(), &resting, nullptr, &at_rest),
            CONTACT_OK);
  expect_failure(
      contact_joint_derivatives(ball.get(), &resting, &at_rest, &d),
      CONTACT_OUT_OF_RANGE,
      "contact_joint_derivatives: solution must be OK and of a joint that "
      "slides under a reaction");
  EXPECT_TRUE(std::isnan(d.over_rate[0]));
}

}  // namespace
}  // namespace contact::test::moments_test
