// Joints with play from C are bit-identical to C++.
#include <gtest/gtest.h>

#include <string>

#include "c/door.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/play/impact.hpp"
#include "libcontact/play/play_joint.hpp"

namespace contact::test::play_test {
namespace {

using contact::test::c_joint;
using contact::test::CJoint;
using contact::test::expect_failure;
using CPlay = std::unique_ptr<contact_play, void (*)(contact_play*)>;

const std::string hip_file = CONTACT_DATA_DIR "/joints/hip_cocr_uhmwpe.toml";

CPlay c_play(const contact_play_options* options) {
  const CJoint joint = c_joint(hip_file);
  contact_play* play = nullptr;
  EXPECT_EQ(contact_play_make(joint.get(), options, &play), CONTACT_OK)
      << contact_last_message();
  return {play, contact_play_free};
}

const contact_play_options options = {0, 0.6, 0.2, 0.01};
const contact_play_motion motion = {
    {0.5e-4, -1e-4, 2e-5}, {0.01, -0.03, 0.002}, {1, 2, -3}, {0, 0, 0}};

TEST(CPlay, IsWhatCppSays) {
  const CPlay play = c_play(&options);
  const contact::JointSpec spec = contact::read_joint(hip_file);
  const contact::PlayJoint::Options as_cpp = {
      contact::HuntCrossley::from_restitution(0.6, 0.2), 0.01};
  const contact::PlayJoint joint(spec, as_cpp);
  double largest = 0;
  ASSERT_EQ(contact_play_largest_penetration(play.get(), &largest), CONTACT_OK);
  EXPECT_EQ(largest, joint.force_law().largest_penetration());

  contact_force_state state;
  ASSERT_EQ(contact_play_force_law(play.get(), 2e-5, &state), CONTACT_OK);
  const contact::ForceState at = joint.force_law().at(2e-5);
  EXPECT_EQ(state.force, at.force);
  EXPECT_EQ(state.slope, at.slope);
  EXPECT_EQ(state.energy, at.energy);
  EXPECT_EQ(state.half_angle, at.half_angle);
  EXPECT_EQ(state.force_ratio, at.force_ratio);
  EXPECT_EQ(state.half_angle_slope, at.half_angle_slope);

  const contact::PlayMotion same = {
      {0.5e-4, -1e-4, 2e-5}, {0.01, -0.03, 0.002}, {1, 2, -3}};
  contact::PlayDerivatives derivatives;
  const contact::PlayForce expected = joint(same, derivatives);
  contact_play_force force;
  double rows[54];
  ASSERT_EQ(contact_play_evaluate(play.get(), &motion, &force, rows),
            CONTACT_OK);
  EXPECT_GT(force.normal_force, 0);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(force.force[i], expected.force(i));
    EXPECT_EQ(force.moment[i], expected.moment(i));
  }
  for (int i = 0; i < 54; ++i) EXPECT_EQ(rows[i], derivatives(i / 9, i % 9));
  EXPECT_EQ(force.penetration, expected.penetration);
  EXPECT_EQ(force.normal_force, expected.normal_force);
  EXPECT_EQ(force.energy, expected.energy);
  EXPECT_EQ(force.damping_power, expected.damping_power);
  EXPECT_EQ(force.friction_power, expected.friction_power);

  contact_impact impact;
  ASSERT_EQ(contact_play_impact(play.get(), 5, 0.05, &impact), CONTACT_OK);
  const contact::Impact of =
      contact::JointImpact(spec)(as_cpp.damping, 5, 0.05);
  EXPECT_EQ(impact.restitution, of.restitution);
  EXPECT_EQ(impact.penetration, of.penetration);
  EXPECT_EQ(impact.elastic_force, of.elastic_force);
  EXPECT_EQ(impact.peak_force, of.peak_force);
  EXPECT_EQ(impact.half_angle, of.half_angle);
  EXPECT_EQ(impact.peak_pressure, of.peak_pressure);
  EXPECT_EQ(impact.compression_time, of.compression_time);
  EXPECT_EQ(impact.restitution_time, of.restitution_time);
}

TEST(CPlay, SaysWhereTheModelEnds) {
  const CPlay play = c_play(nullptr);
  contact_force_state state;
  EXPECT_EQ(contact_play_force_law(play.get(), 1, &state),
            CONTACT_OUT_OF_RANGE);
  EXPECT_TRUE(std::string(contact_last_message())
                  .starts_with("contact_play_force_law: penetration = 1 must "
                               "be at most "))
      << contact_last_message();
  contact_impact impact;
  EXPECT_EQ(contact_play_impact(play.get(), 1e6, 10, &impact),
            CONTACT_OUT_OF_RANGE);
  char text[300];
  ASSERT_EQ(contact_play_impact_notes(play.get(), 1e6, 10, 0, text, 300),
            CONTACT_OK);
  EXPECT_TRUE(std::string(text).starts_with("the impact exceeds the energy"));
  EXPECT_EQ(std::string(text), contact_last_message());
  ASSERT_EQ(contact_play_impact_notes(play.get(), 1e6, 10, 0, text, 4),
            CONTACT_OK);
  EXPECT_STREQ(text, "the");
  ASSERT_EQ(contact_play_motion_notes(play.get(), &motion, text, 300),
            CONTACT_OK);
  EXPECT_STREQ(text, "");
  contact_play_motion far = motion;
  far.position[0] = 1;
  ASSERT_EQ(contact_play_motion_notes(play.get(), &far, text, 300), CONTACT_OK);
  EXPECT_TRUE(std::string(text).starts_with("a penetration of "));
  contact_play_force force;
  EXPECT_EQ(contact_play_evaluate(play.get(), &far, &force, nullptr),
            CONTACT_OUT_OF_RANGE);
}

TEST(CPlay, RefusesWhatCannotBe) {
  contact_play* play = nullptr;
  expect_failure(contact_play_make(nullptr, nullptr, &play), CONTACT_BAD_INPUT,
                 "contact_play_make: joint must be other than NULL");
  const CJoint pin = c_joint(CONTACT_DATA_DIR "/joints/wheel_pin.toml");
  expect_failure(contact_play_make(pin.get(), nullptr, &play),
                 CONTACT_BAD_INPUT,
                 "pin joint with play requires a wall with a backing other "
                 "than an infinite body: in an infinite hole the displacement "
                 "has no limit");
  const contact_play_options wrong = {0, 2, 1, 0};
  const CJoint hip = c_joint(hip_file);
  expect_failure(contact_play_make(hip.get(), &wrong, &play), CONTACT_BAD_INPUT,
                 "impact: restitution = 2 must be above 0, and at most 1");
  const CPlay good = c_play(nullptr);
  expect_failure(contact_play_evaluate(good.get(), nullptr, nullptr, nullptr),
                 CONTACT_BAD_INPUT,
                 "contact_play_evaluate: motion must be other than NULL");
  contact_impact impact;
  expect_failure(contact_play_impact(good.get(), -1, 1, &impact),
                 CONTACT_BAD_INPUT, "impact: mass = -1 must be above 0 kg");
  contact_play_free(nullptr);
}

}  // namespace
}  // namespace contact::test::play_test
