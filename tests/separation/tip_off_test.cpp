// Motions of bodies at events and at the end, against closed forms.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "libcontact/base/units.hpp"
#include "separation/case/case_reader.hpp"
#include "separation/results/run.hpp"
#include "separation/results/saved_state.hpp"
#include "separation/results/summary.hpp"
#include "support/error_message.hpp"
#include "support/toml_text.hpp"

namespace contact::test::tip_off_test {
namespace {

using separation::Case;
using separation::parse_case;

// A ball-like body that turns about one axis at a constant rate, and a carrier
// that burns 2 kg/s.
const std::string bodies = R"(
name = "tip-off"; [run]; end_time_s = 4; output_step_s = 1
[carrier]; name = "lower stage"; mass_kg = 100; principal_inertia_kg_m2 = [10, 10, 10]
[[body]]; name = "upper"; mass_kg = 50; principal_inertia_kg_m2 = [5, 5, 5]
[[body.direction]]; name = "axis"; vector = [2, 0, 0]
[body.start]; velocity_m_per_s = [1, -2, 3]; angular_velocity_deg_per_s = [6, 8, 15]
[[event]]; name = "go"; time_s = 1.5; ends = "run"
[[force]]; name = "engine"; kind = "thrust"; body = "lower stage"; point_m = [0, 0, 0]
direction = [1, 0, 0]; thrust_N = 20; exhaust_speed_m_per_s = 10
)"_toml;

const std::string asked = R"(
[[tip_off]]; body = "upper"; events = "go"; direction = "axis"
[[tip_off]]; body = "lower stage"
)"_toml;

TEST(TipOff, HasTheMotionAtEventsAndAtTheEnd) {
  const Case c = parse_case(bodies + asked, "c.toml");
  const separation::Outcome outcome = run_case(c);
  const auto list = summary(c, outcome)["tip_off"];
  ASSERT_EQ(list.size(), 3u);
  for (const int i : {0, 1}) {
    const auto& of = list[i];
    EXPECT_EQ(of["body"], "upper");
    EXPECT_EQ(of["at"], i == 0 ? "end" : "go");
    EXPECT_EQ(of["time_s"], 1.5);
    const double rates[] = {6, 8, 15}, velocity[] = {1, -2, 3};
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(of["angular_velocity_deg_per_s"][k], rates[k], 1e-12);
      EXPECT_NEAR(of["velocity_m_per_s"][k], velocity[k], 1e-12);
      EXPECT_NEAR(of["attitude_deg"][k], rates[k] * 1.5, 1e-6);
    }
    EXPECT_NEAR(of["tip_off_rate_deg_per_s"], 17, 1e-12);
    EXPECT_FALSE(of.contains("mass_kg"));
  }
  EXPECT_EQ(list[2]["body"], "lower stage");
  EXPECT_NEAR(list[2]["mass_kg"], 97, 1e-12);
  EXPECT_FALSE(list[2].contains("tip_off_rate_deg_per_s"));
  const Case without = parse_case(bodies, "c.toml");
  EXPECT_FALSE(summary(without, run_case(without)).contains("tip_off"));
}

TEST(TipOff, SavedRunsGoOnTheSame) {
  const Case c = parse_case(bodies + asked, "c.toml");
  const std::string identity = separation::identity_of(c, {});
  for (const double time : {1.0, 1.5}) {
    separation::Run run(c), other(c);
    run.advance_to(time);
    other.restore(separation::saved_state(
        separation::saved_bytes(run.save(), identity), identity));
    run.advance_to(4);
    other.advance_to(4);
    EXPECT_EQ(summary(c, run.outcome())["tip_off"],
              summary(c, other.outcome())["tip_off"]);
  }
}

TEST(TipOff, RefusesWhatIsNotThere) {
  const auto message = [](const std::string& keys) {
    return error_message(
        [&] { parse_case(bodies + "[[tip_off]]\n" + keys, "c"); });
  };
  EXPECT_NE(message("body = \"uper\"\n").find("did you mean \"upper\""),
            std::string::npos);
  EXPECT_NE(message("body = \"upper\"\nevents = [\"gone\"]\n")
                .find("tip_off[1].events = [\"gone\"]: unknown event \"gone\""),
            std::string::npos);
  EXPECT_NE(message("body = \"upper\"\ndirection = \"x\"\n")
                .find("unknown direction \"x\""),
            std::string::npos);
  EXPECT_NE(message("body = \"upper\"\n[[tip_off]]\nbody = \"upper\"\n")
                .find("must be a body of no other [[tip_off]]"),
            std::string::npos);
}

}  // namespace
}  // namespace contact::test::tip_off_test
