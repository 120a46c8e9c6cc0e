// The program hinge-separation, run as its users run it.
#include <gtest/gtest.h>
#include <hdf5.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cli/number.hpp"
#include "libcontact/base/units.hpp"
#include "support/program.hpp"

namespace {

using contact::test::csv_column;
using contact::test::csv_rows;
using contact::test::ProgramFolder;
using contact::test::ProgramResult;
using Eigen::Vector3d;
using nlohmann::json;

constexpr double degree = std::numbers::pi / 180;

// A time history; no value is NaN.
class History {
 public:
  explicit History(const std::string& csv) : rows_(csv_rows(csv)) {}

  std::size_t size() const { return rows_.size() - 1; }
  const std::vector<std::string>& columns() const { return rows_.front(); }
  std::vector<std::string> words(const std::string& name) const {
    return csv_column(rows_, name);
  }
  const std::vector<double>& operator[](const std::string& name) const {
    auto& column = numbers_[name];
    if (column.empty()) {
      for (const std::string& cell : words(name)) {
        column.push_back(cli::parse_number(cell).value_or(NAN));
      }
    }
    return column;
  }
  Vector3d vector(const std::string& body, const char* x, const char* y,
                  const char* z, std::size_t row) const {
    return {(*this)[body + x][row], (*this)[body + y][row],
            (*this)[body + z][row]};
  }
  Vector3d position(const std::string& body, std::size_t row) const {
    return vector(body, ".x_m", ".y_m", ".z_m", row);
  }
  Vector3d velocity(const std::string& body, std::size_t row) const {
    return vector(body, ".vx_m_per_s", ".vy_m_per_s", ".vz_m_per_s", row);
  }
  // I w about the centre of mass, inertial axes.
  Vector3d spin(const std::string& body, const Vector3d& inertia,
                std::size_t row) const {
    const Eigen::Quaterniond q(
        (*this)[body + ".qw"][row], (*this)[body + ".qx"][row],
        (*this)[body + ".qy"][row], (*this)[body + ".qz"][row]);
    const Vector3d w =
        vector(body, ".wx_rad_per_s", ".wy_rad_per_s", ".wz_rad_per_s", row);
    return q * inertia.cwiseProduct(w);
  }

 private:
  std::vector<std::vector<std::string>> rows_;
  mutable std::map<std::string, std::vector<double>> numbers_;
};

// What a case says of a carrier that stays where it is.
std::string carrier_at_rest(const std::string& name) {
  return "[carrier]\nname = \"" + name + R"("
mass_kg = 1000
principal_inertia_kg_m2 = [1, 1, 1]
drive = { acceleration_m_per_s2 = [0, 0, 0] })";
}

json run_json(const ProgramFolder& folder, const std::string& arguments) {
  const ProgramResult result = folder.run("hinge-separation " + arguments);
  EXPECT_EQ(result.status, 0) << arguments << '\n' << result.err;
  return json::parse(result.out);
}

const std::vector<std::string> cases = {"soyuz", "two_stage_turn", "slosh",
                                        "flywheels", "platform"};

TEST(HingeSeparation, EveryCaseKeepsItsEnergyAndLeavesNothingBehind) {
  for (const std::string& name : cases) {
    const ProgramFolder folder;
    const json j = run_json(
        folder, "data/cases/" + name + ".toml --history h.csv --events e.csv");
    EXPECT_FALSE(j.contains("failure")) << name;
    EXPECT_EQ(folder.files(), (std::vector<std::string>{"e.csv", "h.csv"}))
        << name;
    const json& drift = j["energy"]["largest_drift_J"];
    EXPECT_EQ(drift.is_null(), name == "two_stage_turn");  // driven carrier
    if (drift.is_null()) continue;
    // Steps at a relative tolerance of 1e-8 to 1e-9, some hundreds of them.
    EXPECT_LT(drift.get<double>(),
              1e-8 * j["energy"]["largest_J"].get<double>())
        << name;
    // Nothing touches anything.
    for (const json& pair : j["clearance"]) {
      EXPECT_GT(pair["smallest_m"].get<double>(), 0.05) << name;
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
    EXPECT_NEAR(release["angle_deg"].get<double>(), 8, 1e-6);
    EXPECT_GT(release["rate_deg_per_s"].get<double>(), 1);
    EXPECT_EQ(body["mode_at_end"], "released");
    EXPECT_GT(body["work_of_friction_J"].get<double>(), 0);
  }
  // Booster 3 is stronger, the others are each other's mirror images.
  EXPECT_LT(upper["booster 3"], upper["booster 1"]);
  EXPECT_NEAR(upper["booster 2"], upper["booster 4"], 1e-6);
  const History h(folder.read("h.csv"));
  for (const std::string& column : h.columns()) {
    if (!column.starts_with("clearance.core")) continue;
    EXPECT_GT(h[column].back(), 50) << column;
  }
  // While it is locked a booster does not move against the core.
  const auto mode = h.words("booster_1.mode");
  for (std::size_t i = 0; i < h.size() && mode[i] == "locked"; ++i) {
    EXPECT_NEAR(h["booster_1.angle_deg"][i], 2.63, 1e-12);
  }
}

// Two bodies that only push each other: nothing from outside.
constexpr const char* alone = R"(
name = "alone"
[run]
end_time_s = 3
output_step_s = 0.05
[carrier]
name = "core"
mass_kg = 100
principal_inertia_kg_m2 = [10, 12, 14]
start = { velocity_m_per_s = [1, 2, -0.5], angular_velocity_rad_per_s = [0.1, -0.2, 0.3] }
[[body]]
name = "tip"
mass_kg = 20
com_m = [0.2, 0.1, 0]
principal_inertia_kg_m2 = [1, 2, 2.5]
[body.hinge]
kind = "ball"
carrier_point_m = [1, 0, 0]
[[body.hinge.joint]]
name = "ball"
kind = "ball"
geometry = { radius_mm = 30, radial_clearance_um = 60 }
materials.inner = { youngs_modulus_GPa = 200, poissons_ratio = 0.3 }
materials.outer = { youngs_modulus_GPa = 200, poissons_ratio = 0.3 }
friction = { coefficient = 0.2, adhesion_MPa = 1 }
[body.lock]
body_point_m = [0.5, 0, 0]
[[event]]
name = "lock opens"
time_s = 0.4
breaks = "lock"
[[event]]
name = "hinge breaks"
after = "lock opens"
delay_s = 0.7
breaks = "hinge"
[[force]]
name = "pusher"
kind = "pusher"
body = "tip"
point_m = [0.1, 0.3, 0]
carrier_point_m = [1.1, 0.3, 0]
direction = [-0.5, 1, 0.2]
first_force_N = 200
last_force_N = 50
stroke_mm = 60
[[force]]
name = "spring"
kind = "spring"
body = "tip"
point_m = [0, 0, 0.4]
carrier_point_m = [0.5, 0.1, 0.5]
stiffness_N_per_m = 300
free_length_m = 0.9
damping_N_s_per_m = 5
)";

TEST(HingeSeparation, MomentaStayBeforeAndAfterTheRelease) {
  const ProgramFolder folder;
  folder.write("c.toml", alone);
  const json j = run_json(folder, "c.toml --history h.csv");
  EXPECT_NEAR(j["bodies"][0]["at_release"]["time_s"].get<double>(), 1.1, 1e-12);
  EXPECT_GT(j["bodies"][0]["work_of_friction_J"].get<double>(), 0);
  // The pusher does push, and its stroke ends.
  EXPECT_GT(j["energy"]["largest_J"].get<double>(), 0);
  EXPECT_LT(j["energy"]["largest_drift_J"].get<double>(),
            1e-7 * j["energy"]["largest_J"].get<double>());
  const History h(folder.read("h.csv"));
  const auto momentum = [&](std::size_t i) -> Vector3d {
    return 100 * h.velocity("core", i) + 20 * h.velocity("tip", i);
  };
  const auto angular = [&](std::size_t i) -> Vector3d {
    return h.spin("core", {10, 12, 14}, i) + h.spin("tip", {1, 2, 2.5}, i) +
           100 * h.position("core", i).cross(h.velocity("core", i)) +
           20 * h.position("tip", i).cross(h.velocity("tip", i));
  };
  const auto relative = [&](std::size_t i) {
    return (h.velocity("tip", i) - h.velocity("core", i)).norm();
  };
  // 1e-9 of the steps' tolerance times some hundreds of steps.
  for (std::size_t i = 0; i < h.size(); ++i) {
    EXPECT_LE((momentum(i) - momentum(0)).norm(), 1e-7 * momentum(0).norm())
        << i;
    EXPECT_LE((angular(i) - angular(0)).norm(), 2e-7 * angular(0).norm()) << i;
  }
  EXPECT_GT(relative(h.size() - 1), 2 * relative(0));
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
    const ProgramResult result =
        folder.run("hinge-separation --compare data/cases/" + name + ".toml");
    EXPECT_EQ(result.status, 0) << result.err;
    const auto rows = csv_rows(result.out);
    EXPECT_EQ(rows[0], (std::vector<std::string>{"body", "quantity", "ideal",
                                                 "full", "traditional"}));
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

// At a reaction level, at an angle already passed when it is armed, together.
TEST(HingeSeparation, EventsOfAllKinds) {
  const ProgramFolder folder;
  const std::string head = R"(
name = "pendulums"
gravity_m_per_s2 = [0, -9.81, 0]
[run]
end_time_s = 4
)" + carrier_at_rest("ceiling") +
                           R"(
[[body]]
name = "mass"
mass_kg = 2
com_m = [1, 0, 0]
principal_inertia_kg_m2 = [0, 0, 0]
[body.hinge]
kind = "axis"
carrier_point_m = [0, 0, 0]
axis = [0, 0, -1]
[body.pattern]
count = 2
axis = [0, 0, 1]
)";
  // From level, the thread's force is 3 m g sin(angle); the second pendulum,
  // turned by 180 deg, swings the other way.
  folder.write("reaction.toml", head + R"(
[[event]]
name = "tears"
reaction_N = 30
bodies = "mass 1"
breaks = "hinge"
)");
  const json torn = run_json(folder, "reaction.toml");
  EXPECT_NEAR(torn["bodies"][0]["at_release"]["angle_deg"].get<double>(),
              std::asin(30 / (3 * 2 * 9.81)) / degree, 1e-5);
  EXPECT_TRUE(torn["bodies"][1]["at_release"].is_null());

  folder.write("late.toml", head + R"(
[[event]]
name = "first"
time_s = 0.3
bodies = "mass 2"
breaks = "hinge"
[[event]]
name = "second"
after = "first"
angle_deg = 5
bodies = "mass 1"
breaks = "hinge"
)");
  const json late = run_json(folder, "late.toml");
  for (const json& body : late["bodies"]) {
    EXPECT_EQ(body["at_release"]["time_s"], 0.3) << body["name"];
  }
  // Opposite turns of equal size.
  const double a = late["bodies"][0]["at_release"]["angle_deg"];
  EXPECT_GT(a, 5);
  EXPECT_NEAR(late["bodies"][1]["at_release"]["angle_deg"].get<double>(), -a,
              1e-6);

  folder.write("together.toml", head + R"(
[[event]]
name = "both"
angle_deg = 60
together = true
breaks = "hinge"
)");
  const json both = run_json(folder, "together.toml");
  EXPECT_EQ(both["bodies"][0]["at_release"]["time_s"],
            both["bodies"][1]["at_release"]["time_s"]);
  // The steps' absolute tolerance is 1e-8 rad, 6e-7 deg; 2.8e-6 was seen.
  EXPECT_NEAR(both["bodies"][0]["at_release"]["angle_deg"].get<double>(), 60,
              1e-5);
}

// A motor whose moment falls from 10 to 2 N m over four turns of a wheel: its
// work gives the rate, full turns count, also when the wheel has come off.
TEST(HingeSeparation, AnglesOfAxesCountFullTurns) {
  const ProgramFolder folder;
  folder.write("wheel.toml", R"(
name = "wheel"
[run]
end_time_s = 3
)" + carrier_at_rest("base") + R"(
[[body]]
name = "wheel"
mass_kg = 2
com_m = [0, 0, 0]
principal_inertia_kg_m2 = [0.3, 0.3, 0.5]
[body.hinge]
kind = "axis"
carrier_point_m = [0, 0, 0]
axis = [0, 0, 1]
[[force]]
name = "motor"
body = "wheel"
kind = "motor"
angle_deg = [0, 1440]
moment_N_m = [10, 2]
ends_at_event = "off"
[[event]]
name = "off"
angle_deg = 800
breaks = "hinge"
)");
  const json wheel =
      run_json(folder, "wheel.toml --history h.csv")["bodies"][0];
  const json& release = wheel["at_release"];
  EXPECT_NEAR(release["angle_deg"].get<double>(), 800, 1e-5);
  const double angle = 800 * degree;
  const double work =
      10 * angle - (10 - 2) / (8 * std::numbers::pi) * angle * angle / 2;
  const double rate = std::sqrt(2 * work / 0.5) / degree;
  // Tolerances of 1e-9 of the rate and 1e-8 rad/s in each step.
  EXPECT_NEAR(release["rate_deg_per_s"].get<double>(), rate, 1e-6 * rate);
  // I x'' = 10 - c x: x = 10/c (1 - cos(w t)).
  const double c = 8 / (8 * std::numbers::pi);
  const double time = std::acos(1 - angle * c / 10) / std::sqrt(c / 0.5);
  EXPECT_NEAR(release["time_s"].get<double>(), time, 1e-7);
  const auto angles = contact::test::csv_column(
      contact::test::csv_rows(folder.read("h.csv")), "wheel.angle_deg");
  EXPECT_NEAR(std::stod(angles.back()),
              800 + std::remainder(rate * (3 - time), 360), 1e-3);
}

// A ball joint that begins to slide where little more than its limit is asked
// of it: friction follows a velocity of next to nothing, which is stiff.
TEST(HingeSeparation, OnsetsOfSlidingDoNotStall) {
  std::string text = R"(
name = "two arms on a tumbling body"
gravity_m_per_s2 = [0, 0, -10]
[run]
end_time_s = 10
output_step_s = 0.02
TOLERANCE
[carrier]
name = "c"
mass_kg = 50
principal_inertia_kg_m2 = [1, 2, 2.5]
start = { angular_velocity_rad_per_s = [0.5, 1, 0.2] }
)";
  for (const std::string arm : {"1", "2"}) {
    text += "[[body]]\nname = \"w" + arm + "\"\nmass_kg = 4\n" +
            "com_m = [0.5, 0, -0." + arm + "]\n" + R"(
principal_inertia_kg_m2 = [0.02, 0.03, 0.02]
start = { rotation_deg = [3, 0, 0] }
[body.hinge]
kind = "ball"
)" + "carrier_point_m = [" +
            arm + ", 0, 0]\n" + R"(
[[body.hinge.joint]]
name = "b"
kind = "ball"
geometry = { radius_mm = 50, radial_clearance_um = 100 }
materials = { pair = "data/materials/steel_bronze.toml" }
friction = { coefficient = 1 }
pressure = { law = "cosine" }
)";
  }
  for (const std::string tolerance : {"1e-8", "1e-10"}) {
    std::string with = text;
    with.replace(with.find("TOLERANCE"), 9,
                 "absolute_tolerance = " + tolerance);
    const ProgramFolder folder;
    folder.write("arms.toml", with);
    const ProgramResult result = folder.run(
        "hinge-separation arms.toml --output a.json --history a.csv");
    ASSERT_EQ(result.status, 0) << result.err;
    const json summary = json::parse(folder.read("a.json"));
    // Some 30,000 now; 7.7 million for 0.1 s of the motion before.
    EXPECT_LT(summary["counts"]["evaluations"].get<long>(), 100'000);
    const auto angles = contact::test::csv_column(
        contact::test::csv_rows(folder.read("a.csv")), "w2.angle_deg");
    // Fixed steps of 5e-6 s give 20.358430; 1.3e-4 less was seen.
    EXPECT_NEAR(std::stod(angles.back()), 20.35843, 5e-4) << tolerance;
  }
}

// A pusher of 100 to 40 N over 0.1 m between bodies of 10 and 5 kg, with the
// part of its stroke that is used at the start and what else its table says.
std::string pushed_case(double used, double speed, const std::string& more) {
  return R"(
name = "pushed"
[run]
end_time_s = 2
[carrier]
name = "c"
mass_kg = 10
principal_inertia_kg_m2 = [1, 1, 1]
[[body]]
name = "s"
mass_kg = 5
principal_inertia_kg_m2 = [1, 1, 1]
[body.start]
position_m = [)" +
         cli::number_text(1 + used) + ", 0, 0]\nvelocity_m_per_s = [" +
         cli::number_text(speed) + R"(, 0, 0]
[[force]]
name = "push"
body = "s"
kind = "pusher"
point_m = [-0.2, 0, 0]
carrier_point_m = [0.8, 0, 0]
direction = [1, 0, 0]
first_force_N = 100
last_force_N = 40
stroke_m = 0.1
)" + more;
}

TEST(HingeSeparation, PusherPushesOnceAndOnlyInItsTime) {
  const ProgramFolder folder;
  const auto last_speeds = [&](const std::string& text) {
    folder.write("c.toml", text);
    run_json(folder, "c.toml --history h.csv");
    const History h(folder.read("h.csv"));
    return std::pair(h["s.vx_m_per_s"].back(), h["c.vx_m_per_s"].back());
  };
  const std::pair still(0.0, 0.0);
  // Used up when it starts, at its end or past it, whatever starts it.
  for (const double used : {0.125, 0.25}) {
    EXPECT_EQ(last_speeds(pushed_case(used, 0, "")), still);
    EXPECT_EQ(last_speeds(pushed_case(used, 0, "starts_at_s = 0.35")), still);
  }
  // Past its stroke only when it starts: the body drifts by 0.35 m before.
  const auto drifted = last_speeds(pushed_case(0, 1, "starts_at_s = 0.35"));
  EXPECT_EQ(drifted, std::pair(1.0, 0.0));
  // The push from `used` to the end of the stroke does its work on the reduced
  // mass; `before` is the relative speed that it finds.
  const auto pushed = [](double used, double before) {
    const double mean = (100 - 600 * used + 40) / 2;
    const double mass = 10 * 5 / 15.0;
    return std::sqrt(before * before + 2 * mean * (0.1 - used) / mass);
  };
  const auto relative = [&](const std::string& text) {
    const auto [body, carrier] = last_speeds(text);
    return body - carrier;
  };
  // Some steps, each to 1e-9.
  constexpr double bound = 1e-7;
  for (const char* start : {"", "starts_at_s = 1"}) {
    EXPECT_NEAR(relative(pushed_case(0, 0, start)), pushed(0, 0), bound);
  }
  // It drifts back from past the end, until 0.05 m are used.
  EXPECT_NEAR(relative(pushed_case(0.25, -0.25, "starts_at_s = 0.8")),
              pushed(0.05, 0.25), bound);
  // Before the pusher starts the body goes past its end and is drawn back,
  // x = t - t^2 until 0.9 s: that does not use up the stroke.
  EXPECT_NEAR(relative(pushed_case(0, 1, R"(starts_at_s = 0.925
[[force]]
name = "back"
body = "s"
kind = "applied"
force_N = [-10, 0, 0]
ends_at_s = 0.9
)")),
              pushed(0.07, 0.8), bound);
}

// On standard error, with the name of the joint.
TEST(HingeSeparation, FitsAreSaid) {
  const ProgramFolder folder;
  std::string text = alone;
  const std::string size = "radius_mm = 30, radial_clearance_um = 60";
  text.replace(text.find(size), size.size(),
               "diameter_mm = 60, hole = \"H7\", shaft = \"f7\"");
  folder.write("c.toml", text);
  const ProgramResult result = folder.run("hinge-separation c.toml");
  EXPECT_EQ(result.status, 0);
  EXPECT_TRUE(result.err.starts_with(
      "hinge-separation: note: joint ball: fit H7/f7 at 60 mm: diametral "
      "clearance 30 to 90 um; mean 60 um taken\n"))
      << result.err;
}

// What is in the file for nothing, or does what was hardly meant.
TEST(HingeSeparation, ForcesThatDoNotDoWhatTheyShouldAreWarnedOf) {
  const ProgramFolder folder;
  const auto warnings = [&](const std::string& text) {
    folder.write("c.toml", text);
    const ProgramResult result = folder.run("hinge-separation c.toml");
    EXPECT_EQ(result.status, 0) << result.err;
    return result.err;
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
  EXPECT_EQ(warnings(pushed_case(0, 0, R"([[force]]
name = "off"
body = "c"
kind = "thrust"
point_m = [0, 0, 0]
direction = [1, 0, 0]
thrust_N = 0
)")),
            warning + "\"off\" never acted on c\n");
  // Before it is used the body is behind; the other way round both centres of
  // mass are where it pushes to.
  EXPECT_EQ(warnings(pushed_case(-0.05, 0, "")),
            warning +
                "\"push\" pushes s and the carrier together: when it "
                "starts, t = 0 s, point is behind carrier_point as seen "
                "along direction\n");
  std::string inwards = pushed_case(0, 0, "");
  inwards.replace(inwards.find("[1, 0, 0]\nfirst"), 9, "[-1, 0, 0]");
  EXPECT_EQ(warnings(inwards),
            warning +
                "\"push\" pushes s and the carrier together: when it "
                "starts, t = 0 s, direction leads from s to the "
                "carrier\n");
  const auto with_spring =
      [](const std::string& end, double free_length, const std::string& more) {
        return pushed_case(0, 0,
                           R"([[force]]
name = "spring"
body = "s"
kind = "spring"
point_m = [-0.2, 0, 0]
stiffness_N_per_m = 10
carrier_point_m = )" + end + "\nfree_length_m = " +
                               cli::number_text(free_length) + "\n" + more);
      };
  EXPECT_EQ(warnings(with_spring("[0.8, 0, 0]", 1, "")),
            warning +
                "\"spring\" has no direction when it starts, t = 0 s: "
                "point on s and carrier_point are in one place\n");
  EXPECT_EQ(warnings(with_spring("[0.8, 0, 0]", 0, "")), "");
  // A spring between bodies that never were on a hinge may pull.
  EXPECT_EQ(warnings(with_spring("[0.5, 0, 0]", 0.4, "")), "");
}

// A compressed spring pushes the body off, and then draws it back.
TEST(HingeSeparation, SpringsThatPullBackAreWarnedOf) {
  const ProgramFolder folder;
  const auto warnings = [&](const std::string& more) {
    folder.write("c.toml", std::string(alone) + R"([[force]]
name = "tie"
kind = "spring"
body = "tip"
point_m = [0.2, 0.1, 0]
carrier_point_m = [0.2, 0.1, 0]
stiffness_N_per_m = 5000
free_length_m = 1.05
)" + more);
    const ProgramResult result =
        folder.run("hinge-separation c.toml --history h.csv");
    EXPECT_EQ(result.status, 0);
    return result.err;
  };
  const std::string pulls = warnings("");
  EXPECT_NE(pulls.find("force \"tie\" pulls tip back after its release, "
                       "from t = "),
            pulls.npos)
      << pulls;
  EXPECT_EQ(
      warnings("ends_at_event = \"hinge breaks\"\n").find("\"tie\" pulls"),
      std::string::npos);
}

// A pendulum whose reaction is above the limit for some milliseconds: whether
// it breaks does not depend on who looks.
TEST(HingeSeparation, OutputTimesDoNotChangeTheMotion) {
  const ProgramFolder folder;
  for (const char* limit : {"58.5", "58.8", "58.84", "58.85", "58.855"}) {
    std::vector<json> releases;
    for (const char* step : {"0.02", "0.001", "4"}) {
      folder.write("c.toml", std::string(R"(
name = "pendulum"
gravity_m_per_s2 = [0, -9.81, 0]
[run]
end_time_s = 4
output_step_s = )") + step + R"(
)" + carrier_at_rest("ceiling") + R"(
[[body]]
name = "mass"
mass_kg = 2
com_m = [1, 0, 0]
principal_inertia_kg_m2 = [0, 0, 0]
[body.hinge]
kind = "axis"
carrier_point_m = [0, 0, 0]
axis = [0, 0, -1]
[[event]]
name = "tears"
breaks = "hinge"
reaction_N = )" + limit + "\n");
      releases.push_back(run_json(folder, "c.toml")["bodies"][0]["at_release"]);
    }
    EXPECT_EQ(releases[0], releases[1]) << limit;
    EXPECT_EQ(releases[0], releases[2]) << limit;
  }
}

// Whatever the order in the file; what is broken does not break again.
TEST(HingeSeparation, LockBreaksBeforeTheHingeAndEachOnce) {
  const ProgramFolder folder;
  std::string text = alone;
  const auto begin = text.find("[[event]]");
  text.replace(begin, text.find("[[force]]") - begin, R"([[event]]
name = "off"
time_s = 0.4
breaks = "hinge"
[[event]]
name = "lock opens"
time_s = 0.4
breaks = "lock"
[[event]]
name = "again"
after = "off"
delay_s = 0.5
breaks = "hinge"
[[event]]
name = "lock again"
time_s = 1
breaks = "lock"
)");
  folder.write("c.toml", text);
  const json result = run_json(folder, "c.toml");
  std::vector<std::string> breaks;
  for (const json& event : result["events"]) {
    if (std::string(event["what"]).ends_with("breaks")) {
      breaks.push_back(event["what"]);
      EXPECT_EQ(event["time_s"], 0.4);
    }
  }
  EXPECT_EQ(breaks, (std::vector<std::string>{"lock opens: lock breaks",
                                              "off: hinge breaks"}));
  EXPECT_EQ(result["bodies"][0]["at_release"]["time_s"], 0.4);
}

TEST(HingeSeparation, LockTakesItsShareOfTheReaction) {
  // A bar of 10 kg between hinge and lock, its middle at 3/4 of the way.
  const ProgramFolder folder;
  folder.write("c.toml", R"(
name = "bar"
gravity_m_per_s2 = [0, -10, 0]
[run]
end_time_s = 0.1
)" + carrier_at_rest("wall") +
                             R"(
[[body]]
name = "bar"
mass_kg = 10
com_m = [1.5, 0, 0]
principal_inertia_kg_m2 = [0, 1, 1]
hinge = { kind = "axis", carrier_point_m = [0, 0, 0], axis = [0, 0, 1] }
lock = { body_point_m = [2, 0, 0] }
)");
  const json j = run_json(folder, "c.toml");
  EXPECT_NEAR(j["bodies"][0]["peak_lock_reaction_N"].get<double>(), 75, 1e-9);
  EXPECT_NEAR(j["bodies"][0]["peak_reaction_N"].get<double>(), 25, 1e-9);
  EXPECT_EQ(j["bodies"][0]["mode_at_end"], "locked");

  // A growing push at the middle: the lock has 3/4 of it, and breaks at 300 N.
  folder.write("lever.toml", folder.read("c.toml") + R"(
[[event]]
name = "lock tears"
reaction_N = 300
node = "lock"
breaks = "lock"
[[force]]
name = "push"
kind = "applied"
body = "bar"
time_s = [0, 0.1]
force_N = [[0, 0, 0], [0, -1000, 0]]
)");
  const json torn = run_json(folder, "lever.toml");
  ASSERT_EQ(torn["events"].size(), 1U);
  EXPECT_EQ(torn["events"][0]["what"], "lock tears: lock breaks");
  // 0.75 (100 N + 10,000 N/s t) = 300 N
  EXPECT_NEAR(torn["events"][0]["time_s"].get<double>(), 0.03, 1e-9);
  EXPECT_EQ(torn["bodies"][0]["mode_at_end"], "sliding");
}

// A balanced wheel on a viscous pin under its weight. Friction is so weak that
// the contact does not change with it: tan g = 3e-4, and a square of that of
// R_n. The rate falls as exp(-c t), c from the area and the pressure (cosine)
// over the contact, whose half-angle the table has.
TEST(HingeSeparation, ViscousWheelSlowsDownExponentially) {
  const ProgramFolder folder;
  folder.write("c.toml", R"(
name = "viscous wheel"
gravity_m_per_s2 = [0, -9.81, 0]
run = { end_time_s = 20 }
)" + carrier_at_rest("wall") +
                             R"(
[[body]]
name = "wheel"
mass_kg = 50
principal_inertia_kg_m2 = [0.005, 0.005, 0.008]
start = { rate_rad_per_s = 6 }
[body.hinge]
kind = "axis"
carrier_point_m = [0, 0, 0]
axis = [0, 0, 1]
[[body.hinge.joint]]
name = "pin"
kind = "pin"
geometry = { radius_mm = 40, radial_clearance_um = 60, length_mm = 50 }
materials = { pair = "data/materials/steel_bronze.toml" }
pressure = { law = "cosine" }
friction = { viscous_constant_kPa_s_per_m = 2, viscous_pressure_slope_s_per_m = 2e-4 }
)");
  const json j = run_json(folder, "c.toml --history h.csv");
  const History h(folder.read("h.csv"));
  const double rho = 0.04, length = 0.05;
  const double t = h["wheel.theta0_deg"][0] * degree;
  const double force = 50 * 9.81;
  const double p0 = force / (rho * length * (t - std::sin(t) * std::cos(t)));
  const double area = 2 * t * rho * length;
  const double pressed =
      2 * p0 * rho * length * (std::sin(t) - t * std::cos(t));
  const double c = rho * rho * (2e3 * area + 2e-4 * pressed) / 0.008;
  EXPECT_GT(c * 20, 1);
  for (std::size_t i = 0; i < h.size(); ++i) {
    // 2e-8 was seen.
    EXPECT_NEAR(h["wheel.rate_deg_per_s"][i] * degree,
                6 * std::exp(-c * h["time_s"][i]), 1e-6);
  }
  // It does not come to rest, and its energy goes into friction.
  EXPECT_TRUE(j["events"].empty());
  EXPECT_EQ(j["bodies"][0]["mode_at_end"], "sliding");
  EXPECT_NEAR(j["bodies"][0]["work_of_friction_J"].get<double>(),
              0.004 * 36 * (1 - std::exp(-40 * c)), 1e-7);
}

// Looked at only at the start and at the end, where nothing pulls.
TEST(HingeSeparation, PeaksBetweenOutputTimes) {
  const ProgramFolder folder;
  const std::string head = R"(
name = "bar"
[run]
end_time_s = 2
output_step_s = 2
)" + carrier_at_rest("wall") +
                           R"(
[[carrier.shape]]
kind = "capsule"
from_m = [3, -1, 0]
to_m = [3, -1, 0]
radius_m = 0.5
[[body]]
name = "bar"
mass_kg = 10
com_m = [1, 0, 0]
principal_inertia_kg_m2 = [0, 0, 0]
hinge = { kind = "axis", carrier_point_m = [0, 0, 0], axis = [0, 0, 1] }
[[body.shape]]
kind = "capsule"
from_m = [1, 0, 0]
to_m = [1, 0, 0]
radius_m = 0.25
)";
  // A pull that grows to 1000 N at 1 s and ends: its last value counts.
  folder.write("pull.toml", head + R"(
[[force]]
name = "pull"
body = "bar"
kind = "applied"
ends_at_s = 1
time_s = [0, 1]
force_N = [[0, 0, 0], [1000, 0, 0]]
)");
  const json pull = run_json(folder, "pull.toml")["bodies"][0];
  EXPECT_NEAR(pull["peak_reaction_N"].get<double>(), 1000, 1e-9);
  EXPECT_NEAR(pull["peak_reaction_time_s"].get<double>(), 1, 1e-15);

  // A pendulum from level, g = 10 m/s^2: 3 m g at the bottom. On its way it
  // passes the ball at (3, -1). The nearest step is some hundredths of a
  // radian away.
  folder.write("swing.toml", head + R"(
[[force]]
name = "weight"
body = "bar"
kind = "applied"
axes = "inertial"
force_N = [0, -100, 0]
)");
  const json swing = run_json(folder, "swing.toml");
  EXPECT_NEAR(swing["bodies"][0]["peak_reaction_N"].get<double>(), 300, 1e-6);
  const json& gap = swing["clearance"][0];
  const double nearest = std::hypot(3, 1) - 1 - 0.75;
  EXPECT_GT(gap["smallest_m"].get<double>(), nearest - 1e-5);
  EXPECT_LT(gap["smallest_m"].get<double>(), nearest + 0.05);
}

// A point mass of 10 kg on an arm of 1 m, let go phi from the bottom in
// g = 10 m/s^2: the peak of its reaction is m g (3 - 2 cos phi), there. Ends of
// steps alone are up to 6e-3 below it. At 1e-6 a peak is as good as the motion.
TEST(HingeSeparation, PeaksOfAPendulum) {
  const ProgramFolder folder;
  for (const double phi : {20, 60, 90, 120, 170}) {
    for (const auto& [tolerance, allowed] :
         {std::pair{"1e-6", 2e-6}, {"1e-9", 1e-9}}) {
      const std::string both = tolerance;
      folder.write("c.toml", R"(
name = "pendulum"
run = { end_time_s = 6, output_step_s = 6, relative_tolerance = )" +
                                 both + ", absolute_tolerance = " + both +
                                 " }\n" + carrier_at_rest("wall") + R"(
[[body]]
name = "bob"
mass_kg = 10
com_m = [1, 0, 0]
principal_inertia_kg_m2 = [0, 0, 0]
hinge = { kind = "axis", carrier_point_m = [0, 0, 0], axis = [0, 0, 1] }
start = { angle_deg = )" + std::to_string(phi - 90) +
                                 R"( }
[[force]]
name = "weight"
body = "bob"
kind = "applied"
axes = "inertial"
force_N = [0, -100, 0]
)");
      const json body = run_json(folder, "c.toml")["bodies"][0];
      const double peak = 100 * (3 - 2 * std::cos(phi * contact::degree));
      EXPECT_NEAR(body["peak_reaction_N"].get<double>(), peak, allowed * peak)
          << phi << ' ' << tolerance;
    }
  }
}

// Every peak of joints that slide and turn against those of a run whose steps
// are some 12 times as short.
TEST(HingeSeparation, PeaksAreThoseOfShortSteps) {
  const ProgramFolder folder;
  std::string text = folder.read("data/cases/platform.toml");
  text.insert(text.find("[run]\n") + 6, "longest_step = 0.01\n");
  for (std::size_t at; (at = text.find("../")) != std::string::npos;) {
    text.replace(at, 3, "data/");
  }
  folder.write("short.toml", text);
  const json one = run_json(folder, "data/cases/platform.toml")["bodies"];
  const json other = run_json(folder, "short.toml")["bodies"];
  const auto compare = [](const json& a, const json& b, const char* key) {
    const double exact = b[key];
    EXPECT_NEAR(a[key].get<double>(), exact, 1e-7 * exact) << key;
  };
  for (std::size_t i = 0; i < one.size(); ++i) {
    compare(one[i], other[i], "peak_reaction_N");
    ASSERT_EQ(one[i]["joints"].size(), other[i]["joints"].size());
    for (std::size_t j = 0; j < one[i]["joints"].size(); ++j) {
      for (const char* key :
           {"peak_reaction_N", "peak_pressure_Pa", "largest_theta0_deg",
            "largest_friction_moment_N_m"}) {
        compare(one[i]["joints"][j], other[i]["joints"][j], key);
      }
    }
  }
}

TEST(HingeSeparation, ResumedRunIsTheSame) {
  const ProgramFolder folder;
  // The last checkpoint is gone on from: wheels that slide and rest, arms that
  // have come off and others, free boosters.
  const auto compare = [&](const std::string& name, const char* every,
                           const char* column) {
    const std::string run = "hinge-separation data/cases/" + name + ".toml ";
    const std::string checkpoint =
        std::string(" --checkpoint-every ") + every + " --checkpoint ";
    ASSERT_EQ(folder
                  .run(run + "--history a.csv --events ae.csv --output a.json" +
                       checkpoint + "c.cbor")
                  .status,
              0);
    const ProgramResult resumed =
        folder.run(run +
                   "--history b.csv --events be.csv --output b.json "
                   "--resume c.cbor" +
                   checkpoint + "d.cbor");
    ASSERT_EQ(resumed.status, 0) << resumed.err;
    // Byte by byte; too long to be printed.
    EXPECT_TRUE(folder.read("a.csv") == folder.read("b.csv")) << name;
    EXPECT_EQ(folder.read("ae.csv"), folder.read("be.csv")) << name;
    json a = json::parse(folder.read("a.json"));
    json b = json::parse(folder.read("b.json"));
    a.erase("counts");
    b.erase("counts");
    EXPECT_EQ(a, b) << name;
    // Without a checkpoint: other steps, the same motion to their tolerance.
    ASSERT_EQ(folder.run(run + "--history s.csv").status, 0);
    const History with(folder.read("a.csv"));
    const History without(folder.read("s.csv"));
    ASSERT_EQ(with.size(), without.size()) << name;
    const double last = without[column].back();
    EXPECT_NEAR(with[column].back(), last, 1e-6 * std::abs(last)) << name;
  };
  compare("flywheels", "21", "wheel_x.angle_deg");
  compare("platform", "2", "arm_2.friction_work_J");
  compare("soyuz", "5", "booster_1.x_m");

  const std::string run = "hinge-separation data/cases/soyuz.toml ";
  const ProgramResult other =
      folder.run("hinge-separation data/cases/slosh.toml --resume c.cbor");
  EXPECT_EQ(other.status, 2);
  EXPECT_EQ(other.err,
            "hinge-separation: c.cbor: a checkpoint of a run of another case "
            "file, other joints or other options\n");
  folder.write("bad.cbor", "nonsense");
  EXPECT_EQ(folder.run(run + "--resume bad.cbor").err,
            "hinge-separation: bad.cbor: not a checkpoint of "
            "hinge-separation\n");
}

TEST(HingeSeparation, SettingsAreAsIfTheFileSaidSo) {
  const ProgramFolder folder;
  std::string text = folder.read("data/cases/flywheels.toml");
  const std::string end = "end_time_s = ";
  ASSERT_NE(text.find(end), std::string::npos);
  text.replace(text.find(end), end.size(), "end_time_s = 0.05 # ");
  for (std::size_t at; (at = text.find("\"../")) != text.npos;) {
    text.replace(at, 4, "\"data/");
  }
  folder.write("other.toml", text);
  const auto history = [&](const std::string& command) {
    const ProgramResult result = folder.run("hinge-separation " + command +
                                            " --history - --output s.json");
    EXPECT_EQ(result.status, 0) << result.err;
    return result.out;
  };
  EXPECT_EQ(history("data/cases/flywheels.toml --set run.end_time_ms=50"),
            history("other.toml"));
}

// Prolonged or cut short on resuming: as if the end had been so from the start.
TEST(HingeSeparation, ResumedRunsEndWhenTheyAreTold) {
  const ProgramFolder folder;
  const auto run = [&](const std::string& more) {
    return folder.run("hinge-separation data/cases/platform.toml " + more);
  };
  const std::string every = " --checkpoint-every 2 --checkpoint ";
  const auto at_once = [&](const std::string& end) {
    ASSERT_EQ(
        run("--history a.csv --events ae.csv --output a.json --end-time " +
            end + every + "a.cbor")
            .status,
        0);
  };
  at_once("8");
  std::rename((folder.path() / "a.cbor").c_str(),
              (folder.path() / "c.cbor").c_str());
  std::rename((folder.path() / "a.cbor.rows1").c_str(),
              (folder.path() / "c.cbor.rows1").c_str());
  // 9.03 s is no output time.
  for (const std::string end : {"12", "9.03", "8"}) {
    at_once(end);
    const ProgramResult resumed =
        run("--history b.csv --events be.csv --output b.json "
            "--resume c.cbor --end-time " +
            end);
    ASSERT_EQ(resumed.status, 0) << resumed.err;
    EXPECT_TRUE(folder.read("a.csv") == folder.read("b.csv")) << end;
    EXPECT_EQ(folder.read("ae.csv"), folder.read("be.csv")) << end;
    json a = json::parse(folder.read("a.json"));
    json b = json::parse(folder.read("b.json"));
    EXPECT_EQ(b["end_time_s"], cli::parse_number(end).value());
    a.erase("counts");
    b.erase("counts");
    EXPECT_EQ(a, b) << end;
  }
  const ProgramResult early = run("--resume c.cbor --end-time 7.9");
  EXPECT_EQ(early.status, 2);
  EXPECT_EQ(early.err,
            "hinge-separation: c.cbor: a checkpoint at t = 8 s requires "
            "--end-time of 8 s or above: this run ends at 7.9 s\n");
  // Of an end that is no output time the row stays.
  ASSERT_EQ(
      run("--end-time 8.03 --checkpoint-every 8.01 --checkpoint d.cbor").status,
      0);
  ASSERT_EQ(run("--resume d.cbor --end-time 12 --history d.csv").status, 0);
  at_once("12");
  const History d(folder.read("d.csv"));
  const History a(folder.read("a.csv"));
  EXPECT_EQ(d.size(), a.size() + 1);
  EXPECT_NEAR(d["arm_2.angle_deg"].back(), a["arm_2.angle_deg"].back(), 1e-5);
}

// Comments, blanks and the notation of numbers are not what is run.
TEST(HingeSeparation, CheckpointsAreOfWhatTheCaseSays) {
  const ProgramFolder folder;
  const std::string text = pushed_case(0, 0, "");
  const auto resumed = [&](const std::string& changed) {
    folder.write("c.toml", changed);
    return folder.run(
        "hinge-separation c.toml --history b.csv --resume c.cbor");
  };
  folder.write("c.toml", text);
  ASSERT_EQ(folder
                .run("hinge-separation c.toml --history a.csv --checkpoint "
                     "c.cbor --checkpoint-every 1.5")
                .status,
            0);
  const auto exchanged = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    const auto at = changed.find(from);
    EXPECT_NE(at, changed.npos);
    return changed.replace(at, from.size(), to);
  };
  for (const std::string& same :
       {"# by hand\n\n" + text, exchanged("mass_kg = 10", "  mass_kg=1.0e1 #"),
        exchanged("[carrier]\nname = \"c\"\nmass_kg = 10",
                  "[carrier]\nmass_kg = 10\nname = \"c\"")}) {
    const ProgramResult result = resumed(same);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(folder.read("a.csv") == folder.read("b.csv"));
  }
  const ProgramResult other =
      resumed(exchanged("mass_kg = 10", "mass_kg = 11"));
  EXPECT_EQ(other.status, 2);
  EXPECT_EQ(other.err,
            "hinge-separation: c.cbor: a checkpoint of a run of another case "
            "file, other joints or other options\n");
}

// A damper that makes explicit steps as short as 1e-7 s, in a motion of 1000 s:
// what has been computed is there however the run is stopped, and it is said
// what held it.
class RunsThatCannotGetOn : public testing::Test {
 protected:
  RunsThatCannotGetOn() {
    std::string text = pushed_case(0, 0, R"(ends_at_s = 0.2
[[force]]
name = "damper"
body = "s"
kind = "spring"
point_m = [-0.2, 0, 0]
carrier_point_m = [0.5, 0, 0]
stiffness_N_per_m = 0
free_length_m = 0.3
damping_N_s_per_m = 1e8
starts_at_s = 0.5
)");
    text.replace(text.find("end_time_s = 2"), 14,
                 "end_time_s = 1000\noutput_step_s = 0.25");
    folder_.write("c.toml", text);
  }
  // Its results are those of a run that was stopped, and whole.
  void expect_results(const ProgramResult& result, int status,
                      const std::string& why) {
    EXPECT_EQ(result.status, status) << result.err;
    const json summary = json::parse(folder_.read("o.json"));
    const std::string failure = summary["failure"];
    EXPECT_NE(failure.find(": stopped by " + why + " after "), failure.npos)
        << failure;
    EXPECT_NE(failure.find("the fastest force is \"damper\" on \"s\" (5e-08 "
                           "s)"),
              failure.npos)
        << failure;
    EXPECT_NE(result.err.find(
                  "hinge-separation: warning: ended early: " + failure + "\n"),
              std::string::npos);
    const History h(folder_.read("h.csv"));
    EXPECT_EQ(h["time_s"].back(), summary["end_time_s"].get<double>());
    EXPECT_GE(h["time_s"].back(), 0.5);
    EXPECT_EQ(h["s.x_m"].size(), h.size());
    EXPECT_TRUE(folder_.read("e.csv").starts_with("time_s,body,what\n"));
    for (const std::string& file : folder_.files()) {
      EXPECT_FALSE(file.starts_with(".")) << file;
    }
  }

  ProgramFolder folder_;
  const std::string run_ =
      "hinge-separation c.toml --history h.csv --events e.csv --output o.json ";
};

TEST_F(RunsThatCannotGetOn, StopAtLimits) {
  const ProgramResult steps = folder_.run(run_ + "--step-limit 3000");
  expect_results(steps, 1, "--step-limit 3000");
  EXPECT_EQ(json::parse(folder_.read("o.json"))["counts"]["steps"], 3000);
  EXPECT_EQ(steps.err.find("--resume"), std::string::npos) << steps.err;
  expect_results(folder_.run(run_ + "--time-limit 2"), 1, "--time-limit 2 s");
}

// Off a terminal too.
TEST_F(RunsThatCannotGetOn, SayHowFarTheyAreEveryTenSeconds) {
  const ProgramResult result = folder_.run(run_ + "--time-limit 11");
  expect_results(result, 1, "--time-limit 11 s");
  EXPECT_TRUE(result.err.starts_with("hinge-separation: 0.")) << result.err;
  EXPECT_NE(result.err.find(" s of 1000 s, "), std::string::npos);
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 2)
      << result.err;
}

// A signal that a shell without job control would have its child ignore comes
// by way of the program env.
TEST_F(RunsThatCannotGetOn, StopAtSignals) {
  for (const auto& [name, status] : {std::pair("INT", 130), {"TERM", 143}}) {
    const ProgramResult result =
        folder_.run("rm -f c.cbor; env --default-signal=INT " + run_ +
                    "--checkpoint c.cbor --checkpoint-every 0.5 & program=$!\n"
                    "while ! [ -e c.cbor ]; do sleep 0.02; done; sleep 0.2; "
                    "kill -" +
                    name + " $program; wait $program");
    expect_results(result, status, std::string("SIG") + name);
    EXPECT_NE(result.err.find("; --resume c.cbor goes on from t = 0.5 s\n"),
              std::string::npos)
        << result.err;
    expect_results(folder_.run(run_ + "--resume c.cbor --step-limit 3000"), 1,
                   "--step-limit 3000");
  }
}

// A run that is killed leaves a checkpoint whose rows go on further than it
// says, and it is not lost when another run begins under its name.
TEST(HingeSeparation, CheckpointsStayWholeAndSmall) {
  const ProgramFolder folder;
  const std::string run = "hinge-separation data/cases/slosh.toml ";
  const auto checkpoints = [&](const char* name, const char* every) {
    EXPECT_EQ(folder
                  .run(run + "--output o.json --history h.csv --checkpoint " +
                       name + " --checkpoint-every " + every)
                  .status,
              0);
  };
  // 0.3 s is no multiple of the output step of 0.05 s in doubles.
  checkpoints("c.cbor", "0.3");
  const std::string history = folder.read("h.csv");
  EXPECT_EQ(folder.files(), (std::vector<std::string>{"c.cbor", "c.cbor.rows1",
                                                      "h.csv", "o.json"}));
  // Of 11 s and of 19.9 s: no rows, no growth but for
  // numbers that have more digits.
  checkpoints("early.cbor", "11");
  checkpoints("late.cbor", "19.9");
  const auto size = [&](const std::string& name) {
    return static_cast<double>(folder.read(name).size());
  };
  EXPECT_NEAR(size("late.cbor"), size("early.cbor"), 100);
  // Rows once, 8 bytes and a sign for each number, and little else.
  const std::size_t rows = std::count(history.begin(), history.end(), '\n') - 1;
  const std::size_t columns = csv_rows(history)[0].size();
  EXPECT_LT(size("c.cbor.rows1"), 10.0 * static_cast<double>(rows * columns));

  // Gone on from as often as before without being told; into the same file.
  const auto resumed = [&](const std::string& more) {
    return folder.run(run + "--output r.json --history r.csv --resume " + more);
  };
  folder.write("c.cbor.rows1", folder.read("c.cbor.rows1") + "the next row");
  EXPECT_EQ(resumed("c.cbor").status, 0);
  EXPECT_TRUE(folder.read("r.csv") == history);
  checkpoints("m.cbor", "13");
  const std::string middle = folder.read("m.cbor");
  const std::string middle_rows = folder.read("m.cbor.rows1");
  EXPECT_EQ(resumed("m.cbor --checkpoint m.cbor --checkpoint-every 3").status,
            0);
  EXPECT_FALSE(folder.has("m.cbor.rows1"));
  EXPECT_TRUE(folder.has("m.cbor.rows2"));
  EXPECT_EQ(resumed("m.cbor").status, 0);
  checkpoints("m.cbor", "13");
  EXPECT_TRUE(folder.has("m.cbor.rows1"));
  EXPECT_FALSE(folder.has("m.cbor.rows2"));
  EXPECT_TRUE(folder.read("m.cbor") == middle);
  EXPECT_TRUE(folder.read("m.cbor.rows1") == middle_rows);

  // Rows of another run, cut short, gone.
  const auto refused = [&](const std::string& expected) {
    const ProgramResult result = resumed("m.cbor");
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err, "hinge-separation: " + expected + '\n');
  };
  folder.write("m.cbor.rows1", folder.read("c.cbor.rows1"));
  refused("m.cbor.rows1: damaged, or not the rows of m.cbor");
  folder.write("m.cbor.rows1", middle_rows.substr(0, middle_rows.size() - 1));
  refused("m.cbor.rows1: damaged, or not the rows of m.cbor");
  EXPECT_EQ(folder.run("rm m.cbor.rows1").status, 0);
  const std::string together =
      "; it has the rows of m.cbor: the two are copied and renamed together";
  refused("m.cbor.rows1: cannot be read: No such file or directory" + together);
  // Renamed together, and the copy of one that leaves the other.
  folder.write("moved.cbor", middle);
  EXPECT_EQ(resumed("moved.cbor").status, 2);
  folder.write("moved.cbor.rows1", middle_rows);
  EXPECT_EQ(resumed("moved.cbor").status, 0);
  EXPECT_EQ(folder.run("rm m.cbor").status, 0);
  refused("m.cbor: cannot be read: No such file or directory");
  EXPECT_EQ(folder.run("mkdir m.cbor").status, 0);
  refused("m.cbor: cannot be read: a directory");
  // Something else is not overwritten.
  folder.write("mine.txt", "mine");
  EXPECT_EQ(folder
                .run(run + "--checkpoint mine.txt --checkpoint-every 1 "
                           "--output x.json")
                .err,
            "hinge-separation: mine.txt: not a checkpoint of "
            "hinge-separation\n");
  EXPECT_EQ(folder.read("mine.txt"), "mine");
}

// A station of 1e9 kg m^2 that begins to turn on its ball joint: the direction
// in which it does follows that of the moment, also from a checkpoint on.
TEST(HingeSeparation, GoesOnInTheMiddleOfASlowOnset) {
  const ProgramFolder folder;
  folder.write("c.toml", R"(
name = "onset"
gravity_m_per_s2 = [0, -9.81, 0]
run = { end_time_s = 20, output_step_s = 1, absolute_tolerance = 1e-14 }
)" + carrier_at_rest("base") +
                             R"(
[[body]]
name = "station"
mass_kg = 50
principal_inertia_kg_m2 = [1e9, 1e9, 1e9]
[body.hinge]
kind = "ball"
carrier_point_m = [0, 0, 0]
[[body.hinge.joint]]
name = "ball"
kind = "ball"
geometry = { radius_mm = 50, radial_clearance_um = 50 }
materials.inner = { youngs_modulus_GPa = 200, poissons_ratio = 0.3 }
materials.outer = { youngs_modulus_GPa = 200, poissons_ratio = 0.3 }
friction = { coefficient = 0.3 }
[[force]]
name = "torque"
body = "station"
kind = "applied"
time_s = [0, 20]
moment_N_m = [[6.9, 0, 0], [7.3, 0, 1.5]]
)");
  const std::string run = "hinge-separation c.toml ";
  ASSERT_EQ(folder.run(run + "--history s.csv --output s.json").status, 0);
  ASSERT_EQ(folder
                .run(run + "--history a.csv --output a.json --checkpoint "
                           "c.cbor --checkpoint-every 12")
                .status,
            0);
  ASSERT_EQ(folder.run(run + "--history b.csv --output b.json --resume c.cbor")
                .status,
            0);
  EXPECT_TRUE(folder.read("b.csv") == folder.read("a.csv"));
  const History without(folder.read("s.csv"));
  const History with(folder.read("a.csv"));
  EXPECT_EQ(with.words("station.mode")[5], "resting");
  EXPECT_EQ(with.words("station.mode")[12], "sliding");
  for (const char* column : {"station.wx_rad_per_s", "station.wz_rad_per_s"}) {
    const double last = without[column].back();
    EXPECT_NEAR(with[column].back(), last, 1e-8 * std::abs(last)) << column;
  }
}

TEST(HingeSeparation, CheckpointsKnowTheirJoints) {
  const ProgramFolder folder;
  std::string text = alone;
  const auto begin = text.find("name = \"ball\"");
  const auto end = text.find("[body.lock]");
  folder.write("ball.toml", text.substr(begin, end - begin));
  text.replace(begin, end - begin, "file = \"ball.toml\"\n");
  folder.write("c.toml", text);
  const std::string run = "hinge-separation c.toml --output o.json ";
  ASSERT_EQ(folder.run(run + "--checkpoint c.cbor --checkpoint-every 1").status,
            0);
  EXPECT_EQ(folder.run(run + "--resume c.cbor").status, 0);
  std::string ball = folder.read("ball.toml");
  ball.replace(ball.find("coefficient = 0.2"), 17, "coefficient = 0.3");
  folder.write("ball.toml", ball);
  const ProgramResult other = folder.run(run + "--resume c.cbor");
  EXPECT_EQ(other.status, 2);
  EXPECT_EQ(other.err,
            "hinge-separation: c.cbor: a checkpoint of a run of another case "
            "file, other joints or other options\n");

  // A wall is known by its thickness and its backing.
  const auto with_wall = [&](const std::string& thickness,
                             const std::string& backing) {
    folder.write("ball.toml",
                 ball + "wall.backing = \"" + backing +
                     "\"\n[[wall.layer]]\nthickness_mm = " + thickness + '\n');
  };
  with_wall("3", "rigid");
  const ProgramResult walled = folder.run(run +
                                          "--checkpoint w.cbor "
                                          "--checkpoint-every 1");
  EXPECT_EQ(walled.status, 0) << walled.err;
  EXPECT_EQ(folder.run(run + "--resume w.cbor").status, 0);
  for (const auto& [thickness, backing] :
       {std::pair("4", "rigid"), std::pair("3", "held")}) {
    with_wall(thickness, backing);
    EXPECT_EQ(folder.run(run + "--resume w.cbor").err,
              "hinge-separation: w.cbor: a checkpoint of a run of another case "
              "file, other joints or other options\n");
  }
  EXPECT_EQ(folder.run("hinge-separation c.toml --law tanh").err,
            "hinge-separation: --law tanh: joint \"ball\": half-angle law tanh "
            "must be exact with finite walls\n");
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
  for (const std::string& column : h.columns()) {
    std::string path = column;
    std::replace(path.begin(), path.end(), '.', '/');
    const hid_t data = H5Dopen2(file, path.c_str(), H5P_DEFAULT);
    ASSERT_GE(data, 0) << path;
    std::vector<double> values(h.size());
    ASSERT_GE(H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                      values.data()),
              0);
    const auto words = h.words(column);
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

TEST(HingeSeparation, WhatDidNotHappenIsReported) {
  const ProgramFolder folder;
  folder.write("c.toml", std::string(alone) + R"(
[[event]]
name = "far"
angle_deg = 179
breaks = "hinge"
[[event]]
name = "after far"
after = "far"
breaks = "hinge"
[[force]]
name = "late"
body = "core"
kind = "applied"
force_N = [1, 0, 0]
starts_at_event = "far"
)");
  const ProgramResult result = folder.run("hinge-separation c.toml");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err,
            "hinge-separation: warning: event \"far\" did not come for tip\n"
            "hinge-separation: warning: event \"after far\" did not come for "
            "tip\n"
            "hinge-separation: warning: force \"late\" did not begin for "
            "core\n"
            "hinge-separation: warning: force \"spring\" pulls tip back after "
            "its release, from t = 1.1 s: it is longer than free_length; "
            "ends_at_event ends it, a pusher only pushes\n");
  const json missed = json::parse(result.out)["events_that_did_not_come"];
  ASSERT_EQ(missed.size(), 2U);
  EXPECT_EQ(missed[0], (json{{"event", "far"}, {"bodies", {"tip"}}}));
  EXPECT_TRUE(
      run_json(folder, "data/cases/soyuz.toml")["events_that_did_not_come"]
          .empty());
}

TEST(HingeSeparation, OverlapAndEarlyEndAreReported) {
  const ProgramFolder folder;
  std::string text = alone;
  text += "[[clearance]]\na = \"core\"\nb = \"tip\"\n";
  EXPECT_NE(text.find("com_m = [0.2, 0.1, 0]\n"), std::string::npos);
  folder.write("c.toml", text);
  const ProgramResult none = folder.run("hinge-separation c.toml");
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.err.find("must be a body with shapes"), std::string::npos);
  const std::string shape =
      "[[%.shape]]\nkind = \"capsule\"\nfrom_m = [0, 0, 0]\n"
      "to_m = [0.2, 0, 0]\nradius_m = 0.9\n";
  const auto insert = [&](const std::string& before, const std::string& table) {
    std::string piece = shape;
    piece.replace(piece.find('%'), 1, table);
    text.insert(text.find(before), piece);
  };
  insert("[[body]]", "carrier");
  insert("[body.hinge]", "body");
  folder.write("c.toml", text);
  const ProgramResult overlap = folder.run("hinge-separation c.toml");
  EXPECT_EQ(overlap.status, 0);
  EXPECT_NE(overlap.err.find("core and tip overlap from t = 0 s to "),
            std::string::npos)
      << overlap.err;

  // The hinge breaks while the lock holds.
  text = alone;
  text.replace(text.find("after = \"lock opens\"\ndelay_s = 0.7"), 34,
               "time_s = 0.2");
  folder.write("c.toml", text);
  const ProgramResult early =
      folder.run("hinge-separation c.toml --history h.csv");
  EXPECT_EQ(early.status, 1);
  EXPECT_NE(early.err.find("t = 0.2 s: event \"hinge breaks\": the hinge of "
                           "\"tip\" breaks while its lock still holds"),
            std::string::npos)
      << early.err;
  EXPECT_TRUE(json::parse(early.out).contains("failure"));
  EXPECT_TRUE(json::parse(early.out)["events"].empty());
  EXPECT_EQ(History(folder.read("h.csv"))["time_s"].back(), 0.2);
}

// The message has the body's name, not its number.
TEST(HingeSeparation, FailureNamesTheBody) {
  const ProgramFolder folder;
  std::string text = folder.read("data/cases/flywheels.toml");
  const auto exchange = [&](const std::string& from, const std::string& to) {
    ASSERT_NE(text.find(from), std::string::npos) << from;
    for (auto at = text.find(from); at != text.npos;
         at = text.find(from, at + to.size())) {
      text.replace(at, from.size(), to);
    }
  };
  exchange("../joints", "data/joints");
  exchange("rate_rpm = 600", "rate_rpm = 1e300");
  folder.write("c.toml", text);
  const ProgramResult result = folder.run("hinge-separation c.toml");
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(json::parse(result.out)["failure"],
            "at 0 s: a force or a velocity is not a finite number "
            "(\"wheel x\")");
  EXPECT_EQ(result.err,
            "hinge-separation: warning: ended early: at 0 s: a force or a "
            "velocity is not a finite number (\"wheel x\")\n");
}

// The law of Hertz ends at half-angles of 90 deg: a joint at rest beyond it is
// not known to hold anything.
TEST(HingeSeparation, TheEndOfALawEndsTheRun) {
  const ProgramFolder folder;
  const auto case_with = [](const std::string& kind, const std::string& run) {
    const bool ball = kind == "ball";
    return "name = \"press and turn\"\n[run]\nend_time_s = 4\n" + run +
           carrier_at_rest("wall") + R"(
[[body]]
name = "arm"
mass_kg = 1000
principal_inertia_kg_m2 = [1e5, 1e5, 1e5]
[body.hinge]
carrier_point_m = [0, 0, 0]
)" + (ball ? "kind = \"ball\"\n" : "kind = \"axis\"\naxis = [0, 0, 1]\n") +
           R"([[body.hinge.joint]]
name = "bearing"
inner_body = "body"
materials = { pair = "data/materials/steel_steel.toml" }
friction = { coefficient = 0.2 }
)" +
           (ball
                ? "kind = \"ball\"\n"
                  "geometry = { radius_mm = 100, relative_clearance = 0.001 }\n"
                : "kind = \"pin\"\n"
                  "geometry = { radius_mm = 100, relative_clearance = 0.001, "
                  "length_mm = 100 }\n") +
           R"(
[[force]]
name = "press"
kind = "applied"
body = "arm"
time_s = [0, 1]
force_MN = [[0, 0, 0], [30, 0, 0]]
[[force]]
name = "turn"
kind = "applied"
body = "arm"
time_s = [1, 10]
moment_N_m = [[0, 0, 0], [0, 0, 3e6]]
)";
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
        // Hertz ends beyond the limit of some materials, which is said too.
        std::string said = result.err;
        const auto line =
            said.find("hinge-separation: warning: joint bearing: ");
        if (line != said.npos) {
          EXPECT_NE(
              said.find("the limit half-angle of these materials\n", line),
              said.npos);
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

// A light body on a large ball with adhesive friction: nearly all of the
// reaction is friction, which turns with it. Newton's method alone finds no
// moments in some of the states on the way.
TEST(HingeSeparation, FrictionThatCarriesNearlyAllOfTheReactionIsFound) {
  const ProgramFolder folder;
  folder.write("c.toml", R"(
name = "ball under heavy friction"
gravity_m_per_s2 = [0, -9.81, 0]
[run]
end_time_s = 0.25
[carrier]
name = "wall"
mass_kg = 1000
principal_inertia_kg_m2 = [100, 100, 100]
drive = { acceleration_m_per_s2 = [0, 0, 0] }
[[body]]
name = "bob"
mass_kg = 20
principal_inertia_kg_m2 = [1, 1, 1]
[body.start]
angular_velocity_rad_per_s = [1, 2, 3]
[body.hinge]
kind = "ball"
body_point_m = [-0.3, 0, 0]
carrier_point_m = [0, 0, 0]
[[body.hinge.joint]]
kind = "ball"
name = "ball"
inner_body = "body"
geometry = { radius_mm = 300, relative_clearance = 0.002 }
materials = { pair = "data/materials/steel_steel.toml" }
friction = { adhesion_MPa = 20, coefficient = 0.1 }
)");
  const ProgramResult result = folder.run("hinge-separation c.toml");
  EXPECT_EQ(result.status, 0) << result.err;
}

// What has been reached by then is in the history.
TEST(HingeSeparation, FailedRunsAreKeptToTheirEnd) {
  const ProgramFolder folder;
  folder.write("c.toml", R"(
name = "a force that nothing can bear"
[run]
end_time_s = 1
output_step_s = 0.4
[carrier]
name = "wall"
mass_kg = 1000
principal_inertia_kg_m2 = [100, 100, 100]
[[body]]
name = "arm"
mass_kg = 1
principal_inertia_kg_m2 = [0.1, 0.1, 0.1]
[body.hinge]
kind = "ball"
body_point_m = [-0.3, 0, 0]
carrier_point_m = [1, 0, 0]
[[force]]
name = "push"
kind = "applied"
body = "arm"
axes = "inertial"
force_N = [0, 1e308, 0]
starts_at_s = 0.55
)");
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

TEST(HingeSeparation, StepsThatAreTooLongAreWarnedOf) {
  const ProgramFolder folder;
  std::string text = folder.read("data/cases/slosh.toml");
  const std::string run = "[run]\n";
  ASSERT_NE(text.find(run), std::string::npos);
  text.insert(text.find(run) + run.size(),
              "integrator = \"rk4\"\nstep_s = 0.5\n");
  folder.write("c.toml", text);
  const ProgramResult result = folder.run("hinge-separation c.toml");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("warning: the energy strays by "),
            std::string::npos)
      << result.err;
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

// A carrier alone and one beside a free body: every output is there, and
// resuming works.
TEST(HingeSeparation, CasesWithoutHingesRun) {
  const ProgramFolder folder;
  const std::string carrier = R"(
name = "alone"
run = { end_time_s = 1 }
[carrier]
name = "core"
density_kg_per_m3 = 1000
start = { velocity_m_per_s = [0, 1, 0] }
shape = [{ kind = "capsule", from = [0, 0, 0], to = [1, 0, 0], radius = 0.1 }]
)";
  folder.write("alone.toml", carrier);
  folder.write("free.toml", carrier + R"(
[[body]]
name = "stone"
density_kg_per_m3 = 1000
start = { position_m = [0, 3, 0] }
shape = [{ kind = "capsule", from = [0, 0, 0], to = [1, 0, 0], radius = 0.1 }]
)");
  for (const std::string name : {"alone", "free"}) {
    const std::string run = "hinge-separation " + name + ".toml ";
    const ProgramResult first =
        folder.run(run +
                   "--history a.csv --events e.csv --output a.json "
                   "--checkpoint c.cbor --checkpoint-every 0.4" +
                   (name == "free" ? " --plot p.svg" : ""));
    ASSERT_EQ(first.status, 0) << first.err;
    EXPECT_EQ(first.err, "");
    EXPECT_EQ(folder.read("e.csv"), "time_s,body,what\n");
    EXPECT_NEAR(History(folder.read("a.csv"))["core.y_m"].back(), 1, 1e-12);
    EXPECT_EQ(folder.run(run + "--resume c.cbor --history b.csv").status, 0);
    EXPECT_EQ(folder.read("a.csv"), folder.read("b.csv"));
    EXPECT_EQ(folder.run(run + "--history a.h5").status, 0);
  }
  EXPECT_TRUE(folder.has("p_clearance.svg"));
  EXPECT_NEAR(json::parse(folder.read("a.json"))["clearance"][0]["smallest_m"],
              3 - 1 - 2 * 0.1, 1e-5);
}

TEST(HingeSeparation, PicturesAreThere) {
  const ProgramFolder folder;
  if (folder.run("command -v gnuplot").status != 0) GTEST_SKIP();
  run_json(folder, "data/cases/soyuz.toml --plot s.svg");
  EXPECT_EQ(folder.files(),
            (std::vector<std::string>{"s_angles.svg", "s_clearance.svg",
                                      "s_rates.svg", "s_reactions.svg"}));
}

}  // namespace
