// Events by distances and clearances that are watched for some time, against
// closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "libcontact/base/units.hpp"
#include "separation/case_runs.hpp"
#include "support/toml_text.hpp"

namespace contact::test::touches_test {
namespace {

using separation::Case;
using separation::Note;
using separation::Outcome;
using separation::parse_case;
using separation::Rows;

// Two capsules side by side, 2.5 m apart, at 2 m/s.
const std::string recontact = R"(
name = "re-contact"; [run]; end_time_s = 4; output_step_s = 0.1
[carrier]; name = "a"; mass_kg = 100; principal_inertia_kg_m2 = [10, 10, 10]
[[carrier.shape]]; kind = "capsule"; from_m = [0, 0, 0]; to_m = [1, 0, 0]; radius_m = 0.3
[[body]]; name = "b"; mass_kg = 50; principal_inertia_kg_m2 = [5, 5, 5]
[[body.shape]]; kind = "capsule"; from_m = [0, 0, 0]; to_m = [1, 0, 0]; radius_m = 0.2
[body.start]; position_m = [0.2, 3, 0]; velocity_m_per_s = [0, -2, 0]
)"_toml;

TEST(Touches, EndTheRun) {
  const std::string text = recontact + R"(
[[event]]; name = "hit"; touches = ["a", "b"]; ends = "run"
)"_toml;
  const Outcome outcome = run_of(text);
  ASSERT_EQ(outcome.memory.notes.size(), 1u);
  const Note& note = outcome.memory.notes[0];
  EXPECT_EQ(note.what, "hit: the run ends");
  EXPECT_EQ(note.body, "b");
  EXPECT_NEAR(note.time, 1.25, 1e-12);
  EXPECT_NEAR(note.approach, 2, 1e-10);
  EXPECT_EQ(outcome.end_time, note.time);
  EXPECT_EQ(outcome.memory.pairs[0].smallest, 0);
  EXPECT_NEAR(outcome.memory.pairs[0].time, 1.25, 1e-12);
  const Rows& rows = outcome.memory.rows;
  EXPECT_EQ(rows.at(rows.size() - 1, 0), note.time);
  // One that is over stays over.
  const Case c = parse_case(text, "c.toml");
  separation::Run run(c), other(c);
  EXPECT_EQ(run.advance_to(2), separation::Run::Status::finished);
  const std::string identity = separation::identity_of(c, {});
  other.restore(separation::saved_state(
      separation::saved_bytes(run.save(), identity), identity));
  EXPECT_EQ(other.advance_to(4), separation::Run::Status::finished);
  EXPECT_EQ(other.time(), note.time);
}

// Without an event it has the same time.
TEST(Touches, HaveTheTimeOfTheCrossing) {
  const Outcome outcome = run_of(recontact);
  EXPECT_NEAR(outcome.memory.pairs[0].time, 1.25, 1e-10);
  EXPECT_NEAR(outcome.memory.pairs[0].overlap_from, 1.25, 1e-10);
}

// Capsules that pass at 0.4 m, radii 0.5 m together, at any speed: they touch
// 0.3 m before the middle, at 0.6 of the speed, and come nearer than 0.3 m,
// from 0.8 m, sqrt(0.48) m before it. Approaches have the third power of 1e-3 m
// times the fourth derivative of the distance, 26/m^3 of the speed and less.
TEST(Touches, AreFoundAtAnySpeed) {
  for (const double speed : {1., 10., 100., 1000., 1e4}) {
    for (const double step : {0.01, 1.}) {
      const double way = 20.37;
      const double end = 2 * way / speed;
      const std::string text =
          "name = \"fly-by\"\n[run]\nend_time_s = " + std::to_string(end) +
          "\noutput_step_s = " + std::to_string(step * end) + R"(
[carrier]; name = "a"; mass_kg = 100; principal_inertia_kg_m2 = [10, 10, 10]
[[carrier.shape]]; kind = "capsule"; from_m = [0, 0, -0.5]; to_m = [0, 0, 0.5]; radius_m = 0.3
[[body]]; name = "b"; mass_kg = 50; principal_inertia_kg_m2 = [5, 5, 5]
[[body.shape]]; kind = "capsule"; from_m = [0, 0, -0.1]; to_m = [0, 0, 0.1]; radius_m = 0.2
[[clearance]]; name = "gap"; a = "b"; b = "a"
[[event]]; name = "near"; clearance = "gap"; distance_m = 0.3
[[event]]; name = "hit"; touches = ["b", "a"]; after = "near"
[body.start]; position_m = [-20.37, 0.4, 0]; velocity_m_per_s = [)"_toml +
          std::to_string(speed) + ", 0, 0]\n";
      const Outcome outcome = run_of(text);
      ASSERT_EQ(outcome.memory.notes.size(), 2u) << speed;
      const Note& near = outcome.memory.notes[0];
      EXPECT_EQ(near.what, "near: occurs");
      EXPECT_NEAR(near.time * speed, way - std::sqrt(0.48), 1e-9) << speed;
      EXPECT_NEAR(near.approach / speed, std::sqrt(0.48) / 0.8, 1e-7);
      EXPECT_NEAR(outcome.memory.notes[1].time * speed, way - 0.3, 1e-9);
      EXPECT_NEAR(outcome.memory.notes[1].approach / speed, 0.6, 1e-7);
    }
  }
}

// The tip of a rod that turns at 2 rad/s comes near a wall: the gap falls with
// L w cos(w t).
TEST(Touches, ApproachOfWhatTurns) {
  const Outcome outcome = run_of(R"(
name = "turn"; [run]; end_time_s = 1
[carrier]; name = "wall"; mass_kg = 100; principal_inertia_kg_m2 = [10, 10, 10]
[[carrier.shape]]; kind = "box"; size_m = [9, 1, 9]; centre_m = [0, 1.5, 0]
[[body]]; name = "rod"; mass_kg = 5; principal_inertia_kg_m2 = [1, 5, 5]
[[body.shape]]; kind = "capsule"; from_m = [0, 0, 0]; to_m = [1, 0, 0]; radius_m = 0.2
[body.start]; angular_velocity_rad_per_s = [0, 0, 2]
[[event]]; name = "hit"; touches = ["wall", "rod"]
)"_toml);
  ASSERT_EQ(outcome.memory.notes.size(), 1u);
  const double angle = std::asin(0.8);
  EXPECT_NEAR(outcome.memory.notes[0].time, angle / 2, 1e-8);
  // Places are known to 1e-10 m, and those that count are 4e-4 s apart.
  EXPECT_NEAR(outcome.memory.notes[0].approach, 2 * std::cos(angle), 1e-6);
}

// Two stages that touch at their plane and go apart at 0.5 m/s; the nozzle of
// one is in the skirt of the other.
const std::string stages = R"(
name = "stages"; [run]; end_time_s = 2; output_step_s = 0.5
[carrier]; name = "lower"; mass_kg = 100; principal_inertia_kg_m2 = [10, 10, 10]
[[carrier.shape]]; name = "skirt"; kind = "cylinder"; from_m = [-1, 0, 0]; to_m = [0, 0, 0]; radius_m = 1
[[carrier.shape]]; name = "floor"; kind = "cylinder"; from_m = [-3, 0, 0]; to_m = [-2, 0, 0]; radius_m = 1
[[body]]; name = "upper"; mass_kg = 50; principal_inertia_kg_m2 = [5, 5, 5]
[[body.shape]]; name = "ring"; kind = "cylinder"; from_m = [0, 0, 0]; to_m = [1, 0, 0]; radius_m = 1
[[body.shape]]; name = "nozzle"; kind = "capsule"; from_m = [-0.5, 0, 0]; to_m = [0, 0, 0]; radius_m = 0.1
[body.start]; velocity_m_per_s = [0.5, 0, 0]
)"_toml;

TEST(Touches, ClearancesHaveTheirTimesAndShapes) {
  std::string text = stages;
  const auto with = [&](const std::string& keys) {
    return run_of(text + "[[clearance]]\na = \"lower\"\nb = \"upper\"\n" +
                  keys);
  };
  EXPECT_EQ(run_of(text).memory.pairs[0].smallest, 0);
  const std::string ring = "b_shapes = [\"ring\"]\na_shapes = \"skirt\"\n";
  const Outcome from = with(ring + "starts_at_s = 0.3\nname = \"ring\"\n");
  EXPECT_NEAR(from.memory.pairs[0].smallest, 0.15, 1e-9);
  EXPECT_EQ(from.memory.pairs[0].time, 0.3);
  const Rows& rows = from.memory.rows;
  const std::size_t column = rows.column("clearance.ring.lower.upper_m");
  EXPECT_TRUE(std::isnan(rows.at(0, column)));
  EXPECT_NEAR(rows.at(rows.size() - 1, column), 1, 1e-9);
  const Outcome nozzle =
      with("b_shapes = [\"nozzle\"]\na_shapes = [\"floor\"]\nends_at_s = 1\n");
  EXPECT_NEAR(nozzle.memory.pairs[0].smallest, 1.4, 1e-9);
  EXPECT_EQ(nozzle.memory.pairs[0].time, 0);
  // Falls to its end.
  text.replace(text.find("[0.5, 0, 0]"), 11, "[-0.5, 0, 0]");
  const Outcome falls =
      with("b_shapes = [\"nozzle\"]\na_shapes = [\"floor\"]\nends_at_s = 1\n");
  EXPECT_NEAR(falls.memory.pairs[0].smallest, 0.9, 1e-9);
  EXPECT_NEAR(falls.memory.pairs[0].time, 1, 1e-12);
}

// Bodies that are near when the watch begins do not come near; bodies that come
// near after its end do not count either.
TEST(Touches, OnlyCrossingsInTheirTimesAreEvents) {
  const auto notes = [](const std::string& keys) {
    return run_of(recontact +
                  "[[clearance]]\nname = \"gap\"\na = \"a\"\nb = \"b\"\n" +
                  keys + R"(
[[event]]; name = "mark"; clearance = "gap"; distance_m = 0.5
)"_toml)
        .memory.notes.size();
  };
  EXPECT_EQ(notes(""), 1u);
  EXPECT_EQ(notes("starts_at_s = 0.9\n"), 1u);
  EXPECT_EQ(notes("starts_at_s = 1.1\n"), 0u);
  EXPECT_EQ(notes("ends_at_s = 1.1\n"), 1u);
  EXPECT_EQ(notes("ends_at_s = 0.9\n"), 0u);
  // From an event that comes for its body.
  const std::string at = "starts_at_event = \"start\"\nstarts_delay_s = ";
  const std::string start = R"(
[[event]]; name = "start"; ends = "run"; time_s = 3.5
)"_toml;
  EXPECT_EQ(notes(at + "0\n" + start), 1u);
}

// A window that an event of each copy opens.
TEST(Touches, WindowsOfCopies) {
  const Outcome outcome = run_of(R"(
name = "copies"; [run]; end_time_s = 3; output_step_s = 0.5
[carrier]; name = "core"; fixed = true
[[carrier.shape]]; kind = "capsule"; from_m = [0, 0, 0]; to_m = [1, 0, 0]; radius_m = 0.5
[[body]]; name = "arm"; mass_kg = 5; com_m = [1, 0, 0]; principal_inertia_kg_m2 = [1, 5, 5]
[[body.shape]]; kind = "capsule"; from_m = [0.2, 0, 0]; to_m = [2, 0, 0]; radius_m = 0.1
[body.pattern]; count = 2; axis = [1, 0, 0]
[body.hinge]; kind = "axis"; axis = [0, 0, 1]; carrier_point_m = [0, 1, 0]
[body.start]; rate_deg_per_s = 10
[[event]]; name = "first"; angle_deg = 10; bodies = "arm 1"; breaks = "hinge"
[[event]]; name = "second"; angle_deg = 20; bodies = "arm 2"; breaks = "hinge"
[[clearance]]; name = "x"; a = "core"; b = "arm 2"; starts_at_event = "second"; starts_delay_s = 0.25
)"_toml);
  EXPECT_NEAR(outcome.memory.pairs[0].time, 2.25, 1e-9);
}

// Three capsules over one another, at those heights and rates.
std::string stack(double b, double c, double rate) {
  const auto capsule = [](const std::string& of) {
    return "[[" + of +
           ".shape]]\nkind = \"capsule\"\nfrom_m = [0, 0, 0]\nto_m = [1, 0, "
           "0]\nradius_m = 0.2\n";
  };
  const auto body = [&](const std::string& name, double y, double vy) {
    return "[[body]]\nname = \"" + name +
           "\"\nmass_kg = 50\nprincipal_inertia_kg_m2 = [5, 5, 5]\n" +
           capsule("body") + "[body.start]\nposition_m = [0, " +
           std::to_string(y) + ", 0]\nvelocity_m_per_s = [0, " +
           std::to_string(vy) + ", 0]\n";
  };
  return "name = \"x\"\n[run]\nend_time_s = 4\noutput_step_s = 0.5\n"
         "[carrier]\nname = \"a\"\nmass_kg = 100\nprincipal_inertia_kg_m2 = "
         "[10, 10, 10]\n" +
         capsule("carrier") + body("b", b, 0) + body("c", c, rate);
}

// Whatever a step has behind it: here it begins 1e-6 s before the crossing.
TEST(Touches, ApproachIsThatOfTheVelocities) {
  const Outcome outcome = run_of(stack(9, 12, -1) + R"(
[[clearance]]; name = "w"; a = "b"; b = "c"; starts_at_s = 1.999999
[[event]]; name = "near"; clearance = "w"; distance_m = 0.6
)"_toml);
  // One event of both bodies, at one time.
  ASSERT_EQ(outcome.memory.notes.size(), 2u);
  for (const Note& note : outcome.memory.notes) {
    EXPECT_NEAR(note.time, 2, 1e-9);
    EXPECT_NEAR(note.approach, 1, 1e-9);
  }
  EXPECT_EQ(outcome.memory.notes[0].time, outcome.memory.notes[1].time);
}

// A pair that overlaps neither hides another nor comes near by its window.
TEST(Touches, OfEachPairForItself) {
  const std::string both = R"(
[[clearance]]; name = "g"; a = "b"; b = "c"
[[event]]; name = "near"; clearance = "g"; distance_m = 0.1; bodies = "b"
[[clearance]]; name = "g"; a = "a"; b = "b"
)"_toml;
  const Outcome falls = run_of(stack(0.3, 3, -1) + both);
  ASSERT_EQ(falls.memory.notes.size(), 1u);
  EXPECT_NEAR(falls.memory.notes[0].time, 2.2, 1e-9);
  EXPECT_NEAR(falls.memory.notes[0].approach, 1, 1e-9);
  const Outcome stays = run_of(stack(0.3, 30, 0) + both + "starts_at_s = 2\n");
  EXPECT_TRUE(stays.memory.notes.empty());
}

}  // namespace
}  // namespace contact::test::touches_test
