// Messages of hinge-separation on cases that go wrong.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "programs/separation/program_runs.hpp"

namespace contact::test::program_warnings_test {
namespace {

// Entries of the file without effect, or with one hardly intended.
TEST(SeparationWarnings, ForcesThatDoNotDoWhatTheyShouldAreWarnedOf) {
  const ProgramFolder folder;
  const auto warnings = [&](const std::string& text) {
    folder.write("c.toml", text);
    return folder.run_well("hinge-separation c.toml").err;
  };
  const std::string warning = "hinge-separation: warning: force ";
  EXPECT_EQ(warnings(pushed_case(0, 0, "")), "");
  EXPECT_EQ(warnings(pushed_case(0, 1, "starts_at_s = 0.05")), "");
  for (const char* start : {"", "starts_at_s = 0.35"}) {
    EXPECT_EQ(warnings(pushed_case(0.125, 0, start)),
              warning +
                  "\"push\" never acted on s: its stroke was used up "
                  "when it started\n");
  }
  EXPECT_EQ(warnings(pushed_case(0, 0, "starts_at_s = 5")),
            warning + "\"push\" did not begin for s\n");
  EXPECT_EQ(
      warnings(pushed_case(
          0, 0,
          R"([[force]]; name = "off"; body = "c"; kind = "thrust"; point_m = [0, 0, 0]
direction = [1, 0, 0]; thrust_N = 0
)"_toml)),
      warning + "\"off\" never acted on c\n");
  // Before it is used the body is behind; the other way round both centres of
  // mass are where it pushes to.
  EXPECT_EQ(warnings(pushed_case(-0.05, 0, "")),
            warning +
                "\"push\" pushes s and the carrier together: when it "
                "starts, t = 0 s, point is behind carrier_point as seen "
                "along direction\n");
  EXPECT_EQ(warnings(exchanged(pushed_case(0, 0, ""), "[1, 0, 0]\nfirst",
                               "[-1, 0, 0]\nfirst")),
            warning +
                "\"push\" pushes s and the carrier together: when it "
                "starts, t = 0 s, direction leads from s to the "
                "carrier\n");
  const auto with_spring = [](const std::string& end, double free_length,
                              const std::string& more) {
    return pushed_case(
        0, 0,
        R"([[force]]; name = "spring"; body = "s"; kind = "spring"; point_m = [-0.2, 0, 0]
stiffness_N_per_m = 10
carrier_point_m = )"_toml +
            end + "\nfree_length_m = " + cli::number_text(free_length) + "\n" +
            more);
  };
  EXPECT_EQ(warnings(with_spring("[0.8, 0, 0]", 1, "")),
            warning +
                "\"spring\" has no direction when it starts, t = 0 s: "
                "point on s and its other end are in one place\n");
  EXPECT_EQ(warnings(with_spring("[0.8, 0, 0]", 0, "")), "");
  // A spring between bodies that never were on a hinge may pull.
  EXPECT_EQ(warnings(with_spring("[0.5, 0, 0]", 0.4, "")), "");
}

// A compressed spring pushes the body off, and then draws it back.
TEST(SeparationWarnings, SpringsThatPullBackAreWarnedOf) {
  const ProgramFolder folder;
  const auto warnings = [&](const std::string& more) {
    folder.write(
        "c.toml",
        alone +
            R"([[force]]; name = "tie"; kind = "spring"; body = "tip"; point_m = [0.2, 0.1, 0]
carrier_point_m = [0.2, 0.1, 0]; stiffness_N_per_m = 5000; free_length_m = 1.05
)"_toml + more);
    return folder.run_well("hinge-separation c.toml --history h.csv").err;
  };
  const std::string pulls = warnings("");
  EXPECT_TRUE(has_text(pulls,
                       "force \"tie\" pulls tip back after its release, "
                       "from t = "));
  EXPECT_FALSE(has_text(warnings("ends_at_event = \"hinge breaks\"\n"),
                        "\"tie\" pulls"));
}

TEST(SeparationWarnings, WhatDidNotHappenIsReported) {
  const ProgramFolder folder;
  folder.write("c.toml", alone + R"(
[[event]]; name = "far"; angle_deg = 179; breaks = "hinge"
[[event]]; name = "after far"; after = "far"; breaks = "hinge"
[[force]]; name = "late"; body = "core"; kind = "applied"; force_N = [1, 0, 0]
starts_at_event = "far"
)"_toml);
  const ProgramResult result = folder.run_well("hinge-separation c.toml");
  EXPECT_EQ(result.err,
            "hinge-separation: warning: event \"far\" did not occur for tip\n"
            "hinge-separation: warning: event \"after far\" did not occur for "
            "tip\n"
            "hinge-separation: warning: force \"late\" did not begin for "
            "core\n"
            "hinge-separation: warning: force \"spring\" pulls tip back after "
            "its release, from t = 1.1 s: it is longer than free_length; "
            "ends_at_event ends it, a pusher only pushes\n");
  const json missed = json::parse(result.out)["missed_events"];
  ASSERT_EQ(missed.size(), 2U);
  EXPECT_EQ(missed[0], (json{{"event", "far"}, {"bodies", {"tip"}}}));
  EXPECT_TRUE(
      run_json(folder, "data/cases/soyuz.toml")["missed_events"].empty());
}

TEST(SeparationWarnings, OverlapAndEarlyEndAreReported) {
  const ProgramFolder folder;
  std::string text = alone + "[[clearance]]\na = \"core\"\nb = \"tip\"\n";
  folder.write("c.toml", text);
  const ProgramResult none = folder.run("hinge-separation c.toml");
  EXPECT_EQ(none.status, 2);
  EXPECT_TRUE(has_text(none.err, "must be a body with shapes"));
  const std::string shape =
      ".shape]]\nkind = \"capsule\"\nfrom_m = [0, 0, 0]\n"
      "to_m = [0.2, 0, 0]\nradius_m = 0.9\n";
  text = exchanged(text, "[[body]]", "[[carrier" + shape + "[[body]]");
  text = exchanged(text, "[body.hinge]", "[[body" + shape + "[body.hinge]");
  folder.write("c.toml", text);
  const ProgramResult overlap = folder.run_well("hinge-separation c.toml");
  EXPECT_TRUE(has_text(overlap.err, "core and tip overlap from t = 0 s to "));

  // The hinge breaks while the lock holds.
  folder.write("c.toml",
               exchanged(alone, "after = \"lock opens\"\ndelay_s = 0.7",
                         "time_s = 0.2"));
  const ProgramResult early =
      folder.run("hinge-separation c.toml --history h.csv");
  EXPECT_EQ(early.status, 1);
  EXPECT_TRUE(has_text(early.err,
                       "t = 0.2 s: event \"hinge breaks\": the hinge of "
                       "\"tip\" breaks while its lock still holds"));
  EXPECT_TRUE(json::parse(early.out).contains("failure"));
  EXPECT_TRUE(json::parse(early.out)["events"].empty());
  EXPECT_EQ(History(folder.read("h.csv"))["time_s"].back(), 0.2);
}

TEST(SeparationWarnings, StepsThatAreTooLongAreWarnedOf) {
  const ProgramFolder folder;
  folder.write("c.toml",
               exchanged(sample_case("slosh"), "[run]\n",
                         "[run]\nintegrator = \"rk4\"\nstep_s = 0.5\n"));
  const ProgramResult result = folder.run_well("hinge-separation c.toml");
  EXPECT_TRUE(has_text(result.err, "warning: the energy balance is off by "));
}

// The message has the body's name, not its number.
TEST(SeparationWarnings, FailureNamesTheBody) {
  const ProgramFolder folder;
  folder.write("c.toml", exchanged(sample_case("flywheels"), "rate_rpm = 600",
                                   "rate_rpm = 1e300"));
  const ProgramResult result = folder.run("hinge-separation c.toml");
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(json::parse(result.out)["failure"],
            "at 0 s: a force or a velocity is not a finite number "
            "(\"wheel x\")");
  EXPECT_EQ(result.err,
            "hinge-separation: warning: ended early: at 0 s: a force or a "
            "velocity is not a finite number (\"wheel x\")\n");
}

// Big rough pins at the folding arm's hinges: what cannot be proven is said.
TEST(SeparationWarnings, FrictionThatIsNotProvenUniqueIsWarnedOf) {
  const ProgramFolder folder;
  const auto run = [&](double times) {
    std::string text = exchanged(sample_case("folding_arm"), "end_time_s = 40",
                                 "end_time_s = 0.02");
    for (const double radius : {40., 30., 20.}) {
      const auto key = [](double r) {
        return "{ radius_mm = " + cli::number_text(r) + ",";
      };
      text = exchanged(text, key(radius), key(times * radius));
      text = exchanged(text, "coefficient = 0.35", "coefficient = 1");
    }
    folder.write("c.toml", text);
    return folder.run("hinge-separation c.toml");
  };
  const auto unproven = [](const ProgramResult& result) {
    return json::parse(result.out)["counts"]["not_proven_unique"].get<int>();
  };
  const ProgramResult weak = run(1);
  EXPECT_EQ(unproven(weak), 0);
  EXPECT_EQ(weak.err, "");
  const ProgramResult strong = run(9);
  EXPECT_EQ(strong.status, 0);
  EXPECT_GT(unproven(strong), 0);
  EXPECT_TRUE(has_text(
      strong.err,
      "evaluations friction is so strong that other friction moments may fit "
      "the reactions as well: a search found none\n"))
      << strong.err;
  const ProgramResult stronger = run(10);
  EXPECT_EQ(stronger.status, 1);
  EXPECT_EQ(json::parse(stronger.out)["failure"],
            "at 0 s: several friction moments fit the reactions they cause "
            "(\"upper arm\")");
}

// The law of Hertz ends at half-angles of 90 deg: a joint at rest beyond it is
// not known to hold anything.
TEST(SeparationWarnings, TheEndOfALawEndsTheRun) {
  const ProgramFolder folder;
  const auto case_with = [](const std::string& kind, const std::string& run) {
    const bool ball = kind == "ball";
    return "name = \"press and turn\"\n[run]\nend_time_s = 4\n" + run +
           carrier_at_rest("wall") + R"(
[[body]]; name = "arm"; mass_kg = 1000
principal_inertia_kg_m2 = [1e5, 1e5, 1e5]
[body.hinge]; carrier_point_m = [0, 0, 0]
)"_toml + (ball ? "kind = \"ball\"\n" : "kind = \"axis\"\naxis = [0, 0, 1]\n") +
           R"([[body.hinge.joint]]; name = "bearing"; inner_body = "body"
materials = { pair = "data/materials/steel_steel.toml" }
friction = { coefficient = 0.2 }
)"_toml +
           (ball
                ? "kind = \"ball\"\n"
                  "geometry = { radius_mm = 100, relative_clearance = 0.001 }\n"
                : "kind = \"pin\"\n"
                  "geometry = { radius_mm = 100, relative_clearance = 0.001, "
                  "length_mm = 100 }\n") +
           R"(
[[force]]; name = "press"; kind = "applied"; body = "arm"; time_s = [0, 1]
force_MN = [[0, 0, 0], [30, 0, 0]]
[[force]]; name = "turn"; kind = "applied"; body = "arm"; time_s = [1, 10]
moment_N_m = [[0, 0, 0], [0, 0, 3e6]]
)"_toml;
  };
  for (const std::string kind : {"ball", "pin"}) {
    for (const std::string run : {"", "integrator = \"rk4\"\nstep_ms = 10\n"}) {
      folder.write("c.toml", case_with(kind, run));
      for (const std::string friction : {"full", "traditional"}) {
        const std::string arguments = "c.toml --friction " + friction;
        SCOPED_TRACE(kind + ' ' + run + friction);
        const json slides = run_json(folder, arguments);
        EXPECT_EQ(slides["events"][0]["what"], "begins to slide");

        const ProgramResult result =
            folder.run("hinge-separation " + arguments +
                       " --law hertz --history h.csv --events e.csv");
        EXPECT_EQ(result.status, 1);
        const json summary = json::parse(result.out);
        const std::string failure = summary["failure"];
        // A ball's last contact may pass the limit half-angle, 87.89 deg to
        // 0.1 %; a pin's is wider than this pin is long before Hertz ends.
        const double theta0 =
            summary["bodies"][0]["joints"][0]["largest_theta0_deg"];
        const bool is_ball = kind == "ball";
        std::string said = result.err;
        const auto line =
            said.find("hinge-separation: warning: joint bearing: ");
        EXPECT_EQ(line != said.npos, !is_ball || theta0 > 1.001 * 87.89)
            << theta0 << said;
        if (line != said.npos) {
          EXPECT_TRUE(has_text(said.substr(line),
                               is_ball ? "the limit half-angle of this joint\n"
                                       : "wider than the pin is long"));
          said.erase(line);
        }
        EXPECT_EQ(said,
                  "hinge-separation: warning: ended early: " + failure + '\n');
        double time = NAN, force = NAN;
        ASSERT_EQ(std::sscanf(failure.c_str(),
                              "at %lf s: half-angle law hertz has no value "
                              "under %lf N (\"arm\", joint \"bearing\")",
                              &time, &force),
                  2)
            << failure;
        EXPECT_TRUE(failure.ends_with("joint \"bearing\")"));
        // Before the turn begins.
        EXPECT_LT(time, 1);
        EXPECT_NEAR(force, 30e6 * time, 1e-5 * force);
        EXPECT_EQ(summary["end_time_s"], time);
        const History history(folder.read("h.csv"));
        EXPECT_EQ(history["time_s"].back(), time);
        EXPECT_NEAR(history["arm.reaction_N"].back(), force, 1e-5 * force);
        EXPECT_EQ(folder.read("e.csv"), "time_s,body,what\n");
      }
    }
  }
}

// The history has everything up to the failure.
TEST(SeparationWarnings, FailedRunsAreKeptToTheirEnd) {
  const ProgramFolder folder;
  folder.write("c.toml", R"(
name = "a force that nothing can bear"
[run]; end_time_s = 1; output_step_s = 0.4
[carrier]; name = "wall"; mass_kg = 1000
principal_inertia_kg_m2 = [100, 100, 100]
[[body]]; name = "arm"; mass_kg = 1; principal_inertia_kg_m2 = [0.1, 0.1, 0.1]
[body.hinge]; kind = "ball"; body_point_m = [-0.3, 0, 0]
carrier_point_m = [1, 0, 0]
[[force]]; name = "push"; kind = "applied"; body = "arm"; axes = "inertial"
force_N = [0, 1e308, 0]; starts_at_s = 0.55
)"_toml);
  const ProgramResult result =
      folder.run("hinge-separation c.toml --history h.csv");
  EXPECT_EQ(result.status, 1) << result.err;
  const json summary = json::parse(result.out);
  EXPECT_TRUE(summary.contains("failure"));
  const std::vector<double> times = History(folder.read("h.csv"))["time_s"];
  EXPECT_EQ(times.size(), 3u);
  EXPECT_EQ(times.back(), summary["end_time_s"]);
  EXPECT_NEAR(times.back(), 0.55, 1e-9);
}

}  // namespace
}  // namespace contact::test::program_warnings_test
