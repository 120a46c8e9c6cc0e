// Rigid stops of ball hinges in cases: the sheet's numbers, the limit of steep
// compliant stops, friction, latches and saved runs.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "libcontact/base/units.hpp"
#include "separation/case_runs.hpp"
#include "support/toml_text.hpp"

namespace contact::test::ball_stops_test {
namespace {

using separation::Case;
using separation::Outcome;
using separation::parse_case;
using std::numbers::pi;

// J = 15 kg m^2 on the ground, driven by 2 N m about x from 30 to 120 deg: the
// numbers of a boom on an axis, e = 0.4.
std::string boom(const std::string& stops) {
  return R"(
[carrier]; name = "ground"; fixed = true
direction = [{ name = "up", vector = [0, 0, 1] }]
[[body]]; name = "boom"; mass_kg = 1; principal_inertia_kg_m2 = [15, 15, 15]
direction = [{ name = "up", vector = [0, 0, 1] }]
start = { rotation_deg = [30, 0, 0] }
[body.hinge]; kind = "ball"; body_direction = "up"; carrier_direction = "up"
)"_toml + stops +
         R"(
[[force]]; name = "drive"; kind = "applied"; body = "boom"; moment_N_m = [2, 0, 0]
)"_toml;
}

TEST(BallStops, BouncesAreThoseOnAnAxis) {
  const Outcome outcome =
      run_of(run_for(13) + boom(stop("angle_deg = 120\nrestitution = 0.4")));
  const auto hits = notes_of(outcome, "hits its stop");
  ASSERT_GT(hits.size(), 8u);
  EXPECT_NEAR(hits[0].time, 4.854064781389, 1e-10);
  EXPECT_NEAR(hits[0].rate / degree, 37.0823233942, 1e-9);
  EXPECT_NEAR(hits[0].impulse, 13.5913813879, 1e-9);
  EXPECT_NEAR(hits[1].time, 8.737316606501, 1e-10);
  EXPECT_NEAR(hits[2].time, 10.290617336545, 1e-9);
  const auto rests = notes_of(outcome, "rests on its stop");
  ASSERT_EQ(rests.size(), 1u);
  EXPECT_NEAR(rests[0].time, 11.326151156575, 1e-8);
  EXPECT_NEAR(last(outcome, "energy.impacts_J"), pi, 1e-9);
  EXPECT_NEAR(last(outcome, "energy.balance_J"), 0, 1e-9);
  EXPECT_NEAR(last(outcome, "boom.stop_moment_N_m"), 2, 1e-11);
  const auto& record = outcome.memory.bodies[0];
  EXPECT_NEAR(record.peak_stop, 2, 1e-11);
  EXPECT_EQ(record.impacts, static_cast<double>(hits.size()));
  EXPECT_EQ(record.largest_impulse, hits[0].impulse);
  EXPECT_NEAR(record.stop_loss, pi, 1e-9);
  // It rests on the stop, not by friction.
  EXPECT_NEAR(record.rest_on_stop, 13 - rests[0].time, 1e-12);
  EXPECT_EQ(record.rest_time, 0);
  EXPECT_NEAR(record.stop_impulses,
              1.4 * 15 * std::sqrt(pi * 2 / 15) / (1 - 0.4), 9e-5);
}

// Two stops, without a drive: to and fro, slower by e each time.
TEST(BallStops, OnBothSides) {
  std::string text =
      run_for(2.2) + boom(stop("angle_deg = 50\nrestitution = 0.5") +
                          stop("angle_deg = 20\nrestitution = 0.5"));
  text.erase(text.find("[[force]]"));
  text.insert(text.find("}\n[body.hinge]"),
              ", angular_velocity_deg_per_s = [100, 0, 0] ");
  const auto hits = notes_of(run_of(text), "hits its stop");
  ASSERT_EQ(hits.size(), 3u);
  const double times[] = {0.2, 0.8, 2.0}, rates[] = {100, -50, 25};
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(hits[i].time, times[i], 1e-11);
    EXPECT_NEAR(hits[i].rate / degree, rates[i], 1e-10);
  }
}

// A latch at the angle of the stop comes before it, once the body is slow
// enough.
TEST(BallStops, LatchesComeFirst) {
  const Outcome outcome =
      run_of(run_for(13) + boom(stop("angle_deg = 120\nrestitution = 0.4")) +
             "[[event]]\nname = \"latch\"\nlocks = \"hinge\"\n"
             "angle_deg = 120\nrate_below_deg_per_s = 10\n");
  EXPECT_EQ(notes_of(outcome, "latch: hinge does not engage").size(), 2u);
  EXPECT_EQ(notes_of(outcome, "hits its stop").size(), 2u);
  const auto latches = notes_of(outcome, "latch: hinge latches");
  ASSERT_EQ(latches.size(), 1u);
  EXPECT_NEAR(latches[0].time, 10.290617336545, 1e-9);
  EXPECT_NEAR(latches[0].impulse, 15 * 0.16 * std::sqrt(pi * 2 / 15), 1e-9);
  EXPECT_NEAR(last(outcome, "energy.impacts_J"), pi, 1e-9);
  EXPECT_NEAR(last(outcome, "boom.latch_moment_N_m"), 2, 1e-9);
  EXPECT_EQ(last(outcome, "boom.stop_moment_N_m"), 0);
}

// A bob on an arm that swings out to a cone about a slanted direction, and
// turns along it.
std::string pendulum(const std::string& stops, const std::string& joint = "",
                     const std::string& turn = "[0.3, 3.5, 0]") {
  return R"(
[carrier]; name = "ground"; fixed = true
direction = [{ name = "down", vector = [0.3, 0, -1] }]
[[body]]; name = "bob"; mass_kg = 3; principal_inertia_kg_m2 = [0.3, 0.3, 0.1]
direction = [{ name = "arm", vector = [0, 0, -1] }]
)"_toml + "start = { rotation_deg = [25, 0, 0], angular_velocity_rad_per_s = " +
         turn + " }\n" + R"(
[body.hinge]; kind = "ball"; body_direction = "arm"; carrier_direction = "down"
body_point_m = [0, 0, 1]
)"_toml + stops +
         joint;
}
const std::string weight = "gravity_m_per_s2 = [0, 0, -9.81]\n";

TEST(BallStops, SteepCompliantOnesAreRigid) {
  const std::string from = "angle_deg = 40\nfrom = \"below\"\nrestitution = ";
  const Outcome rigid = run_of(run_for(6, weight) + pendulum(stop(from + "0")));
  EXPECT_EQ(notes_of(rigid, "rests on its stop").size(), 1u);
  EXPECT_EQ(notes_of(rigid, "leaves its stop").size(), 1u);
  EXPECT_GT(rigid.memory.bodies[0].rest_on_stop, 0.5);
  double before = 1;
  for (const char* k : {"1e4", "1e6"}) {
    const Outcome soft =
        run_of(run_for(6, weight) +
               pendulum(stop(from + "1e-3\nstiffness_N_m_per_rad = " + k)));
    double off = 0;
    for (const char* axis : {"x", "y", "z"}) {
      const std::string column = std::string("bob.") + axis + "_m";
      off = std::max(off, std::abs(last(soft, column) - last(rigid, column)));
    }
    EXPECT_LT(off, 0.2 * before);
    before = off;
  }
}

// With friction the bob bounces on the cone from outside, rests on it, turns
// along it to and fro and comes to rest. All energy is in the book, and runs
// saved at any of these times go on to the same bytes.
TEST(BallStops, FrictionHoldsAtTheStop) {
  const std::string joint = R"(
[[body.hinge.joint]]; name = "ball"; kind = "ball"; inner_body = "body"
geometry = { radius_mm = 200, radial_clearance_um = 100 }
[body.hinge.joint.materials]; liner = false; pair = ")"_toml +
                            std::string(CONTACT_DATA_DIR) +
                            "/materials/cocr_uhmwpe.toml\"\n";
  const Case c = parse_case(
      run_for(20, weight) +
          pendulum(stop("angle_deg = 25\nfrom = \"above\"\nrestitution = 0.5"),
                   joint, "[0, 0, 0]"),
      "c.toml");
  separation::Run whole(c, {});
  const std::string identity = separation::identity_of(c, {});
  whole.advance_to(20);
  const Outcome& outcome = whole.outcome();
  ASSERT_EQ(outcome.failure, "");
  const auto rests = notes_of(outcome, "rests on its stop");
  const auto leaves = notes_of(outcome, "leaves its stop");
  const auto stays = notes_of(outcome, "comes to rest");
  ASSERT_EQ(rests.size(), 2u);
  ASSERT_EQ(leaves.size(), 1u);
  ASSERT_EQ(stays.size(), 1u);
  EXPECT_GT(stays[0].time, rests[1].time);
  const auto& record = outcome.memory.bodies[0];
  EXPECT_NEAR(record.rest_time, 20 - stays[0].time, 1e-12);
  EXPECT_NEAR(record.rest_on_stop,
              20 - rests[1].time + leaves[0].time - rests[0].time, 1e-12);
  EXPECT_GT(last(outcome, "bob.stop_moment_N_m"), 4);
  EXPECT_GT(last(outcome, "bob.utilisation"), 0.05);
  EXPECT_LT(last(outcome, "bob.utilisation"), 1);
  EXPECT_NEAR(last(outcome, "bob.angle_deg"), 25, 1e-10);
  EXPECT_LT(outcome.memory.largest_drift, 1e-9);
  EXPECT_GT(record.stop_loss, 0.1);
  EXPECT_GT(record.work, 0.1);
  for (const double time : {rests[0].time - 1e-7, 1.8, 10.0, 19.0}) {
    separation::Run first(c, {});
    first.advance_to(time);
    const std::string bytes = separation::saved_bytes(first.save(), identity);
    separation::Run second(c, {});
    second.restore(separation::saved_state(bytes, identity));
    first.advance_to(20);
    second.advance_to(20);
    EXPECT_EQ(separation::saved_bytes(first.save(), identity),
              separation::saved_bytes(second.save(), identity))
        << time;
  }
}

}  // namespace
}  // namespace contact::test::ball_stops_test
