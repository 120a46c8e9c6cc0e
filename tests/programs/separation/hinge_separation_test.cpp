// The program hinge-separation, run as its users run it.
#include <gtest/gtest.h>
#include <hdf5.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "programs/separation/program_runs.hpp"

namespace contact::test::hinge_separation_test {
namespace {

const std::vector<std::string> cases = {"soyuz", "two_stage_turn", "slosh",
                                        "flywheels", "platform"};

TEST(HingeSeparation, EveryCaseKeepsItsEnergyAndLeavesNothingBehind) {
  for (const std::string& name : cases) {
    const ProgramFolder folder;
    const json j = run_json(
        folder, "data/cases/" + name + ".toml --history h.csv --events e.csv");
    EXPECT_FALSE(j.contains("failure")) << name;
    EXPECT_EQ(folder.files(), (Texts{"e.csv", "h.csv"})) << name;
    const json& drift = j["energy"]["largest_drift_J"];
    EXPECT_EQ(drift.is_null(), name == "two_stage_turn");  // driven carrier
    if (drift.is_null()) continue;
    // Steps at a relative tolerance of 1e-8 to 1e-9, some hundreds of them.
    EXPECT_LT(drift, 1e-8 * j["energy"]["largest_J"].get<double>()) << name;
    // Nothing touches anything.
    for (const json& pair : j["clearance"]) {
      EXPECT_GT(pair["smallest_m"], 0.05) << name;
    }
    const History h(folder.read("h.csv"));
    EXPECT_EQ(h["time_s"].back(), j["end_time_s"].get<double>());
    EXPECT_TRUE(std::is_sorted(h["time_s"].begin(), h["time_s"].end()));
  }
}

TEST(HingeSeparation, BoostersComeOffAtTheAngleAskedForAndDriftClear) {
  const ProgramFolder folder;
  const json j = run_json(folder, "data/cases/soyuz.toml --history h.csv");
  std::map<std::string, double> lower, upper;
  for (const json& event : j["events"]) {
    const std::string what = event["what"];
    auto& times = what.starts_with("lower") ? lower : upper;
    if (what.ends_with("breaks")) times[event["body"]] = event["time_s"];
  }
  EXPECT_EQ(lower.size(), 4U);
  EXPECT_EQ(upper.size(), 4U);
  for (const json& body : j["bodies"]) {
    const std::string name = body["name"];
    EXPECT_EQ(lower[name], 0.5);
    const json& release = body["at_release"];
    EXPECT_EQ(release["time_s"], upper[name]);
    // The root of the angle, to the tolerance of the steps.
    EXPECT_NEAR(release["angle_deg"], 8, 1e-6);
    EXPECT_GT(release["rate_deg_per_s"], 1);
    EXPECT_EQ(body["mode_at_end"], "released");
    EXPECT_GT(body["work_of_friction_J"], 0);
  }
  // Booster 3 is stronger, the others are each other's mirror images.
  EXPECT_LT(upper["booster 3"], upper["booster 1"]);
  EXPECT_NEAR(upper["booster 2"], upper["booster 4"], 1e-6);
  const History h(folder.read("h.csv"));
  for (const std::string& column : h.names()) {
    if (!column.starts_with("clearance.core")) continue;
    EXPECT_GT(h[column].back(), 50) << column;
  }
  // While it is locked a booster does not move against the core.
  const auto mode = h.texts("booster_1.mode");
  for (std::size_t i = 0; i < h.size() && mode[i] == "locked"; ++i) {
    EXPECT_NEAR(h["booster_1.angle_deg"][i], 2.63, 1e-12);
  }
}

// theory: example 2 of the paper, converged: R_n, M and the braking.
TEST(HingeSeparation, TwoStageTurnBeginsAsExample2OfThePaper) {
  struct Row {
    double acceleration, moment, reaction, half_angle;
  };
  const auto first_row = [](const std::string& friction) {
    const ProgramFolder folder;
    run_json(folder,
             "data/cases/two_stage_turn.toml --history h.csv "
             "--friction " +
                 friction);
    const History h(folder.read("h.csv"));
    return Row{h["stage.acceleration_deg_per_s2"][0],
               h["stage.friction_moment_N_m"][0], h["stage.reaction_N"][0],
               h["stage.theta0_deg"][0]};
  };
  const Row ideal = first_row("ideal");
  const Row full = first_row("full");
  const Row traditional = first_row("traditional");
  // The file's numbers have 8 digits.
  EXPECT_NEAR(ideal.acceleration, 8.67, 1e-6);
  EXPECT_NEAR(ideal.reaction, 2 * std::hypot(1.122e6, 3.23e5), 1);
  // Digits as the outer loop of example 2 gives them.
  EXPECT_NEAR(full.moment, 1.1491e5, 10);
  EXPECT_NEAR(full.half_angle, 45.34, 5e-3);
  EXPECT_NEAR(full.acceleration - ideal.acceleration, -0.747, 5e-4);
  EXPECT_NEAR(full.reaction,
              2 * std::hypot(1.122e6, 3.23e5 - 0.026 * full.moment), 1);
  // Friction from R instead of R_n: about twice.
  EXPECT_NEAR(traditional.moment, 2.26e5, 5e2);
}

TEST(HingeSeparation, FrictionIsBetweenIdealAndTheTraditionalEstimate) {
  for (const std::string name : {"two_stage_turn", "soyuz"}) {
    const ProgramFolder folder;
    const ProgramResult result = folder.run_well(
        "hinge-separation --compare data/cases/" + name + ".toml");
    const auto rows = csv_rows(result.out);
    EXPECT_EQ(rows[0],
              (Texts{"body", "quantity", "ideal", "full", "traditional"}));
    int compared = 0;
    for (const auto& row : rows) {
      if (row[1] != "rate_at_release_deg_per_s") continue;
      ++compared;
      const double ideal = *cli::parse_number(row[2]);
      const double full = *cli::parse_number(row[3]);
      const double traditional = *cli::parse_number(row[4]);
      EXPECT_GT(ideal, full) << name << ' ' << row[0];
      EXPECT_GT(full, traditional) << name << ' ' << row[0];
    }
    EXPECT_EQ(compared, name == "soyuz" ? 4 : 1);
  }
}

// A carrier alone, and one with a free body: every output is written, and
// resuming works.
TEST(HingeSeparation, CasesWithoutHingesRun) {
  const ProgramFolder folder;
  const std::string carrier = R"(
name = "alone"; run = { end_time_s = 1 }
[carrier]; name = "core"; density_kg_per_m3 = 1000
start = { velocity_m_per_s = [0, 1, 0] }
shape = [{ kind = "capsule", from = [0, 0, 0], to = [1, 0, 0], radius = 0.1 }]
)"_toml;
  folder.write("alone.toml", carrier);
  folder.write("free.toml", carrier + R"(
[[body]]; name = "stone"; density_kg_per_m3 = 1000
start = { position_m = [0, 3, 0] }
shape = [{ kind = "capsule", from = [0, 0, 0], to = [1, 0, 0], radius = 0.1 }]
)"_toml);
  for (const std::string name : {"alone", "free"}) {
    const std::string run = "hinge-separation " + name + ".toml ";
    const ProgramResult first =
        folder.run_well(run +
                        "--history a.csv --events e.csv --output a.json "
                        "--checkpoint c.cbor --checkpoint-every 0.4" +
                        (name == "free" ? " --plot p.svg" : ""));
    EXPECT_EQ(first.err, "");
    EXPECT_EQ(folder.read("e.csv"), "time_s,body,what\n");
    EXPECT_NEAR(History(folder.read("a.csv"))["core.y_m"].back(), 1, 1e-12);
    folder.run_well(run + "--resume c.cbor --history b.csv");
    EXPECT_EQ(folder.read("a.csv"), folder.read("b.csv"));
    folder.run_well(run + "--history a.h5");
  }
  EXPECT_TRUE(folder.has("p_clearance.svg"));
  EXPECT_NEAR(json::parse(folder.read("a.json"))["clearance"][0]["smallest_m"],
              3 - 1 - 2 * 0.1, 1e-5);
}

TEST(HingeSeparation, SettingsAreAsIfTheFileSaidSo) {
  const ProgramFolder folder;
  folder.write("other.toml",
               exchanged(sample_case("flywheels"),
                         "end_time_s = ", "end_time_s = 0.05 # "));
  const auto history = [&](const std::string& command) {
    return folder
        .run_well("hinge-separation " + command +
                  " --history - --output s.json")
        .out;
  };
  EXPECT_EQ(history("data/cases/flywheels.toml --set run.end_time_ms=50"),
            history("other.toml"));
}

// Every column, with hinges that are gone and values that are missing.
TEST(HingeSeparation, Hdf5HoldsWhatTheTableHolds) {
  const ProgramFolder folder;
  run_json(folder, "data/cases/soyuz.toml --history h.csv");
  run_json(folder, "data/cases/soyuz.toml --history h.h5");
  const History h(folder.read("h.csv"));
  const hid_t file =
      H5Fopen((folder.path() / "h.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  const std::vector<std::string> modes = {"sliding", "resting", "locked",
                                          "released"};
  std::set<std::string> seen;
  for (const std::string& column : h.names()) {
    std::string path = column;
    std::replace(path.begin(), path.end(), '.', '/');
    const hid_t data = H5Dopen2(file, path.c_str(), H5P_DEFAULT);
    ASSERT_GE(data, 0) << path;
    std::vector<double> values(h.size());
    ASSERT_GE(H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                      values.data()),
              0);
    const auto words = h.texts(column);
    for (std::size_t i = 0; i < h.size(); ++i) {
      if (column.ends_with(".mode")) {
        ASSERT_EQ(modes.at(static_cast<std::size_t>(values[i])), words[i]);
        seen.insert(words[i]);
      } else if (words[i].empty()) {
        ASSERT_TRUE(std::isnan(values[i])) << column << ' ' << i;
      } else {
        ASSERT_EQ(values[i], h[column][i]) << column << ' ' << i;
      }
    }
    if (column.ends_with(".angle_deg") || column == "time_s") {
      EXPECT_GT(H5Aexists(data, "unit"), 0) << path;
    }
    H5Dclose(data);
  }
  EXPECT_EQ(seen, (std::set<std::string>{"locked", "released", "sliding"}));
  H5Fclose(file);
}

TEST(HingeSeparation, NamesInCapitalsAreTheSame) {
  const ProgramFolder folder;
  const std::string run = "data/cases/slosh.toml --format json ";
  run_json(folder, run + "--history h.csv --events e.csv");
  run_json(folder, run + "--history H.CSV --events E.CSV");
  run_json(folder, run + "--history H.H5");
  EXPECT_TRUE(folder.read("h.csv") == folder.read("H.CSV"));
  EXPECT_EQ(folder.read("e.csv"), folder.read("E.CSV"));
  EXPECT_GT(H5Fis_hdf5((folder.path() / "H.H5").c_str()), 0);
}

// On standard error, with the name of the joint.
TEST(HingeSeparation, FitsAreSaid) {
  const ProgramFolder folder;
  folder.write("c.toml",
               exchanged(alone, "radius_mm = 30, radial_clearance_um = 60",
                         "diameter_mm = 60, hole = \"H7\", shaft = \"f7\""));
  const ProgramResult result = folder.run_well("hinge-separation c.toml");
  EXPECT_TRUE(result.err.starts_with(
      "hinge-separation: note: joint ball: fit H7/f7 at 60 mm: diametral "
      "clearance 30 to 90 um; mean 60 um taken\n"))
      << result.err;
}

TEST(HingeSeparation, PicturesAreThere) {
  const ProgramFolder folder;
  if (!folder.has_gnuplot()) GTEST_SKIP();
  run_json(folder, "data/cases/soyuz.toml --plot s.svg");
  EXPECT_EQ(folder.files(), (Texts{"s_angles.svg", "s_clearance.svg",
                                   "s_rates.svg", "s_reactions.svg"}));
}

}  // namespace
}  // namespace contact::test::hinge_separation_test
