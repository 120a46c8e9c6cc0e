// Motions of hinge-separation against what is known of them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "libcontact/base/units.hpp"
#include "programs/separation/program_runs.hpp"

namespace contact::test::program_motion_test {
namespace {

using Eigen::Vector3d;

TEST(SeparationMotion, MomentaStayBeforeAndAfterTheRelease) {
  const ProgramFolder folder;
  folder.write("c.toml", alone);
  const json j = run_json(folder, "c.toml --history h.csv");
  EXPECT_NEAR(j["bodies"][0]["at_release"]["time_s"], 1.1, 1e-12);
  EXPECT_GT(j["bodies"][0]["work_of_friction_J"], 0);
  // The pusher does push, and its stroke ends.
  EXPECT_GT(j["energy"]["largest_J"], 0);
  EXPECT_LT(j["energy"]["largest_drift_J"],
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

// A point mass on an arm of 1 m that is level at first.
const std::string hanging_mass = R"(
[[body]]; name = "mass"; mass_kg = 2; com_m = [1, 0, 0]
principal_inertia_kg_m2 = [0, 0, 0]
[body.hinge]; kind = "axis"; carrier_point_m = [0, 0, 0]; axis = [0, 0, -1]
)"_toml;

// At a reaction level, at an angle already passed when it is armed, together.
TEST(SeparationMotion, EventsOfAllKinds) {
  const ProgramFolder folder;
  const std::string head = R"(
name = "pendulums"; gravity_m_per_s2 = [0, -9.81, 0]
[run]; end_time_s = 4
)"_toml + carrier_at_rest("ceiling") +
                           hanging_mass +
                           R"([body.pattern]; count = 2; axis = [0, 0, 1]
)"_toml;
  // From level, the thread's force is 3 m g sin(angle); the second pendulum,
  // turned by 180 deg, swings the other way.
  folder.write("reaction.toml", head + R"(
[[event]]; name = "tears"; reaction_N = 30; bodies = "mass 1"; breaks = "hinge"
)"_toml);
  const json torn = run_json(folder, "reaction.toml");
  EXPECT_NEAR(torn["bodies"][0]["at_release"]["angle_deg"],
              std::asin(30 / (3 * 2 * 9.81)) / degree, 1e-5);
  EXPECT_TRUE(torn["bodies"][1]["at_release"].is_null());

  folder.write("late.toml", head + R"(
[[event]]; name = "first"; time_s = 0.3; bodies = "mass 2"; breaks = "hinge"
[[event]]; name = "second"; after = "first"; angle_deg = 5; bodies = "mass 1"
breaks = "hinge"
)"_toml);
  const json late = run_json(folder, "late.toml");
  for (const json& body : late["bodies"]) {
    EXPECT_EQ(body["at_release"]["time_s"], 0.3) << body["name"];
  }
  // Opposite turns of equal size.
  const double a = late["bodies"][0]["at_release"]["angle_deg"];
  EXPECT_GT(a, 5);
  EXPECT_NEAR(late["bodies"][1]["at_release"]["angle_deg"], -a, 1e-6);

  folder.write("together.toml", head + R"(
[[event]]; name = "both"; angle_deg = 60; together = true; breaks = "hinge"
)"_toml);
  const json both = run_json(folder, "together.toml");
  EXPECT_EQ(both["bodies"][0]["at_release"]["time_s"],
            both["bodies"][1]["at_release"]["time_s"]);
  // The steps' absolute tolerance is 1e-8 rad, 6e-7 deg; 2.8e-6 was seen.
  EXPECT_NEAR(both["bodies"][0]["at_release"]["angle_deg"], 60, 1e-5);
}

// A pendulum whose reaction exceeds the limit for some milliseconds: whether it
// breaks must not depend on the output times.
TEST(SeparationMotion, OutputTimesDoNotChangeTheMotion) {
  const ProgramFolder folder;
  for (const char* limit : {"58.5", "58.8", "58.84", "58.85", "58.855"}) {
    std::vector<json> releases;
    for (const char* step : {"0.02", "0.001", "4"}) {
      folder.write("c.toml", std::string(R"(
name = "pendulum"; gravity_m_per_s2 = [0, -9.81, 0]
[run]; end_time_s = 4
output_step_s = )"_toml) + step + R"(
)" + carrier_at_rest("ceiling") + hanging_mass +
                                 R"([[event]]; name = "tears"; breaks = "hinge"
reaction_N = )"_toml + limit + "\n");
      releases.push_back(run_json(folder, "c.toml")["bodies"][0]["at_release"]);
    }
    EXPECT_EQ(releases[0], releases[1]) << limit;
    EXPECT_EQ(releases[0], releases[2]) << limit;
  }
}

// A motor whose moment falls from 10 to 2 N m over four turns of a wheel: its
// work gives the rate, full turns count, also when the wheel has come off.
TEST(SeparationMotion, AnglesOfAxesCountFullTurns) {
  const ProgramFolder folder;
  folder.write("wheel.toml", R"(
name = "wheel"
[run]; end_time_s = 3
)"_toml + carrier_at_rest("base") +
                                 R"(
[[body]]; name = "wheel"; mass_kg = 2; com_m = [0, 0, 0]
principal_inertia_kg_m2 = [0.3, 0.3, 0.5]
[body.hinge]; kind = "axis"; carrier_point_m = [0, 0, 0]; axis = [0, 0, 1]
[[force]]; name = "motor"; body = "wheel"; kind = "motor"
angle_deg = [0, 1440]; moment_N_m = [10, 2]; ends_at_event = "off"
[[event]]; name = "off"; angle_deg = 800; breaks = "hinge"
)"_toml);
  const json wheel =
      run_json(folder, "wheel.toml --history h.csv")["bodies"][0];
  const json& release = wheel["at_release"];
  EXPECT_NEAR(release["angle_deg"], 800, 1e-5);
  const double angle = 800 * degree;
  const double work =
      10 * angle - (10 - 2) / (8 * std::numbers::pi) * angle * angle / 2;
  const double rate = std::sqrt(2 * work / 0.5) / degree;
  // Tolerances of 1e-9 of the rate and 1e-8 rad/s in each step.
  EXPECT_NEAR(release["rate_deg_per_s"], rate, 1e-6 * rate);
  // I x'' = 10 - c x: x = 10/c (1 - cos(w t)).
  const double c = 8 / (8 * std::numbers::pi);
  const double time = std::acos(1 - angle * c / 10) / std::sqrt(c / 0.5);
  EXPECT_NEAR(release["time_s"], time, 1e-7);
  const auto angles =
      csv_column(csv_rows(folder.read("h.csv")), "wheel.angle_deg");
  EXPECT_NEAR(std::stod(angles.back()),
              800 + std::remainder(rate * (3 - time), 360), 1e-3);
}

// A ball joint that begins to slide slightly above its limit: friction follows
// a tiny velocity, which is stiff.
TEST(SeparationMotion, OnsetsOfSlidingDoNotStall) {
  std::string text = R"(
name = "two arms on a tumbling body"; gravity_m_per_s2 = [0, 0, -10]
[run]; end_time_s = 10; output_step_s = 0.02
TOLERANCE
[carrier]; name = "c"; mass_kg = 50; principal_inertia_kg_m2 = [1, 2, 2.5]
start = { angular_velocity_rad_per_s = [0.5, 1, 0.2] }
)"_toml;
  for (const std::string arm : {"1", "2"}) {
    text += "[[body]]\nname = \"w" + arm + "\"\nmass_kg = 4\n" +
            "com_m = [0.5, 0, -0." + arm + "]\n" + R"(
principal_inertia_kg_m2 = [0.02, 0.03, 0.02]
start = { rotation_deg = [3, 0, 0] }
[body.hinge]; kind = "ball"
)"_toml + "carrier_point_m = [" +
            arm + ", 0, 0]\n" + R"(
[[body.hinge.joint]]; name = "b"; kind = "ball"
geometry = { radius_mm = 50, radial_clearance_um = 100 }
materials = { pair = "data/materials/steel_bronze.toml" }
friction = { coefficient = 1 }; pressure = { law = "cosine" }
)"_toml;
  }
  for (const std::string tolerance : {"1e-8", "1e-10"}) {
    const ProgramFolder folder;
    folder.write("arms.toml", exchanged(text, "TOLERANCE",
                                        "absolute_tolerance = " + tolerance));
    folder.run_well(
        "hinge-separation arms.toml --output a.json --history a.csv");
    const json summary = json::parse(folder.read("a.json"));
    // Some 30,000 now; 7.7 million for 0.1 s of the motion before.
    EXPECT_LT(summary["counts"]["evaluations"].get<long>(), 100'000);
    const auto angles =
        csv_column(csv_rows(folder.read("a.csv")), "w2.angle_deg");
    // Fixed steps of 5e-6 s give 20.358430; 1.3e-4 less was seen.
    EXPECT_NEAR(std::stod(angles.back()), 20.35843, 5e-4) << tolerance;
  }
}

// A light body on a large ball with adhesive friction: nearly all of the
// reaction is friction, which turns with it. Newton's method alone finds no
// moments in some of the states on the way.
TEST(SeparationMotion, FrictionThatCarriesNearlyAllOfTheReactionIsFound) {
  const ProgramFolder folder;
  folder.write("c.toml", R"(
name = "ball under heavy friction"; gravity_m_per_s2 = [0, -9.81, 0]
[run]; end_time_s = 0.25
[carrier]; name = "wall"; mass_kg = 1000
principal_inertia_kg_m2 = [100, 100, 100]
drive = { acceleration_m_per_s2 = [0, 0, 0] }
[[body]]; name = "bob"; mass_kg = 20; principal_inertia_kg_m2 = [1, 1, 1]
[body.start]; angular_velocity_rad_per_s = [1, 2, 3]
[body.hinge]; kind = "ball"; body_point_m = [-0.3, 0, 0]
carrier_point_m = [0, 0, 0]
[[body.hinge.joint]]; kind = "ball"; name = "ball"; inner_body = "body"
geometry = { radius_mm = 300, relative_clearance = 0.002 }
materials = { pair = "data/materials/steel_steel.toml" }
friction = { adhesion_MPa = 20, coefficient = 0.1 }
)"_toml);
  folder.run_well("hinge-separation c.toml");
}

// A balanced wheel on a viscous pin under its weight. Friction is so weak that
// the contact does not depend on it: tan g = 3e-4, with an effect on R_n of its
// square. The rate falls as exp(-c t), with c from the area and the pressure
// (cosine) over the contact; the table gives the half-angle.
TEST(SeparationMotion, ViscousWheelSlowsDownExponentially) {
  const ProgramFolder folder;
  folder.write("c.toml", R"(
name = "viscous wheel"; gravity_m_per_s2 = [0, -9.81, 0]
run = { end_time_s = 20 }
)"_toml + carrier_at_rest("wall") +
                             R"(
[[body]]; name = "wheel"; mass_kg = 50
principal_inertia_kg_m2 = [0.005, 0.005, 0.008]; start = { rate_rad_per_s = 6 }
[body.hinge]; kind = "axis"; carrier_point_m = [0, 0, 0]; axis = [0, 0, 1]
[[body.hinge.joint]]; name = "pin"; kind = "pin"
geometry = { radius_mm = 40, radial_clearance_um = 60, length_mm = 50 }
materials = { pair = "data/materials/steel_bronze.toml" }
pressure = { law = "cosine" }
friction = { viscous_constant_kPa_s_per_m = 2, viscous_pressure_slope_s_per_m = 2e-4 }
)"_toml);
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
  // It does not come to rest; friction dissipates its energy.
  EXPECT_TRUE(j["events"].empty());
  EXPECT_EQ(j["bodies"][0]["mode_at_end"], "sliding");
  EXPECT_NEAR(j["bodies"][0]["work_of_friction_J"],
              0.004 * 36 * (1 - std::exp(-40 * c)), 1e-7);
}

TEST(SeparationMotion, PusherPushesOnceAndOnlyInItsTime) {
  const ProgramFolder folder;
  const auto last_speeds = [&](const std::string& text) {
    folder.write("c.toml", text);
    run_json(folder, "c.toml --history h.csv");
    const History h(folder.read("h.csv"));
    return std::pair(h["s.vx_m_per_s"].back(), h["c.vx_m_per_s"].back());
  };
  const std::pair still(0.0, 0.0);
  // Used up when it starts, at its end or beyond, for any kind of start.
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
[[force]]; name = "back"; body = "s"; kind = "applied"; force_N = [-10, 0, 0]
ends_at_s = 0.9
)"_toml)),
              pushed(0.07, 0.8), bound);
}

// Whatever the order in the file; what is broken does not break again.
TEST(SeparationMotion, LockBreaksBeforeTheHingeAndEachOnce) {
  const ProgramFolder folder;
  std::string text = alone;
  const auto begin = text.find("[[event]]");
  text.replace(begin, text.find("[[force]]") - begin,
               R"([[event]]; name = "off"; time_s = 0.4; breaks = "hinge"
[[event]]; name = "lock opens"; time_s = 0.4; breaks = "lock"
[[event]]; name = "again"; after = "off"; delay_s = 0.5; breaks = "hinge"
[[event]]; name = "lock again"; time_s = 1; breaks = "lock"
)"_toml);
  folder.write("c.toml", text);
  const json result = run_json(folder, "c.toml");
  std::vector<std::string> breaks;
  for (const json& event : result["events"]) {
    if (std::string(event["what"]).ends_with("breaks")) {
      breaks.push_back(event["what"]);
      EXPECT_EQ(event["time_s"], 0.4);
    }
  }
  EXPECT_EQ(breaks, (Texts{"lock opens: lock breaks", "off: hinge breaks"}));
  EXPECT_EQ(result["bodies"][0]["at_release"]["time_s"], 0.4);
}

TEST(SeparationMotion, LockTakesItsShareOfTheReaction) {
  // A bar of 10 kg between hinge and lock, its middle at 3/4 of the way.
  const ProgramFolder folder;
  folder.write("c.toml", R"(
name = "bar"; gravity_m_per_s2 = [0, -10, 0]
[run]; end_time_s = 0.1
)"_toml + carrier_at_rest("wall") +
                             R"(
[[body]]; name = "bar"; mass_kg = 10; com_m = [1.5, 0, 0]
principal_inertia_kg_m2 = [0, 1, 1]
hinge = { kind = "axis", carrier_point_m = [0, 0, 0], axis = [0, 0, 1] }
lock = { body_point_m = [2, 0, 0] }
)"_toml);
  const json j = run_json(folder, "c.toml");
  EXPECT_NEAR(j["bodies"][0]["peak_lock_reaction_N"], 75, 1e-9);
  EXPECT_NEAR(j["bodies"][0]["peak_reaction_N"], 25, 1e-9);
  EXPECT_EQ(j["bodies"][0]["mode_at_end"], "locked");

  // A growing push at the middle: the lock has 3/4 of it, and breaks at 300 N.
  folder.write("lever.toml", folder.read("c.toml") + R"(
[[event]]; name = "lock tears"; reaction_N = 300; node = "lock"
breaks = "lock"
[[force]]; name = "push"; kind = "applied"; body = "bar"; time_s = [0, 0.1]
force_N = [[0, 0, 0], [0, -1000, 0]]
)"_toml);
  const json torn = run_json(folder, "lever.toml");
  ASSERT_EQ(torn["events"].size(), 1U);
  EXPECT_EQ(torn["events"][0]["what"], "lock tears: lock breaks");
  // 0.75 (100 N + 10,000 N/s t) = 300 N
  EXPECT_NEAR(torn["events"][0]["time_s"], 0.03, 1e-9);
  EXPECT_EQ(torn["bodies"][0]["mode_at_end"], "sliding");
}

// Looked at only at the start and at the end, where nothing pulls.
TEST(SeparationMotion, PeaksBetweenOutputTimes) {
  const ProgramFolder folder;
  const std::string head = R"(
name = "bar"
[run]; end_time_s = 2; output_step_s = 2
)"_toml + carrier_at_rest("wall") +
                           R"(
[[carrier.shape]]; kind = "capsule"; from_m = [3, -1, 0]; to_m = [3, -1, 0]
radius_m = 0.5
[[body]]; name = "bar"; mass_kg = 10; com_m = [1, 0, 0]
principal_inertia_kg_m2 = [0, 0, 0]
hinge = { kind = "axis", carrier_point_m = [0, 0, 0], axis = [0, 0, 1] }
[[body.shape]]; kind = "capsule"; from_m = [1, 0, 0]; to_m = [1, 0, 0]
radius_m = 0.25
)"_toml;
  // A pull that grows to 1000 N at 1 s and ends: its last value counts.
  folder.write("pull.toml", head + R"(
[[force]]; name = "pull"; body = "bar"; kind = "applied"; ends_at_s = 1
time_s = [0, 1]; force_N = [[0, 0, 0], [1000, 0, 0]]
)"_toml);
  const json pull = run_json(folder, "pull.toml")["bodies"][0];
  EXPECT_NEAR(pull["peak_reaction_N"], 1000, 1e-9);
  EXPECT_NEAR(pull["peak_reaction_time_s"], 1, 1e-15);

  // A pendulum from level, g = 10 m/s^2: 3 m g at the bottom. On its way it
  // passes the ball at (3, -1). The nearest step is some hundredths of a
  // radian away.
  folder.write("swing.toml", head + R"(
[[force]]; name = "weight"; body = "bar"; kind = "applied"; axes = "inertial"
force_N = [0, -100, 0]
)"_toml);
  const json swing = run_json(folder, "swing.toml");
  EXPECT_NEAR(swing["bodies"][0]["peak_reaction_N"], 300, 1e-6);
  const json& gap = swing["clearance"][0];
  const double nearest = std::hypot(3, 1) - 1 - 0.75;
  EXPECT_GT(gap["smallest_m"], nearest - 1e-5);
  EXPECT_LT(gap["smallest_m"], nearest + 0.05);
}

// A point mass of 10 kg on an arm of 1 m, let go phi from the bottom in
// g = 10 m/s^2: the peak of its reaction is m g (3 - 2 cos phi), there. Ends of
// steps alone are up to 6e-3 below it. At 1e-6 a peak is as good as the motion.
TEST(SeparationMotion, PeaksOfAPendulum) {
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
[[body]]; name = "bob"; mass_kg = 10; com_m = [1, 0, 0]
principal_inertia_kg_m2 = [0, 0, 0]
hinge = { kind = "axis", carrier_point_m = [0, 0, 0], axis = [0, 0, 1] }
start = { angle_deg = )"_toml + std::to_string(phi - 90) +
                                 R"( }
[[force]]; name = "weight"; body = "bob"; kind = "applied"; axes = "inertial"
force_N = [0, -100, 0]
)"_toml);
      const json body = run_json(folder, "c.toml")["bodies"][0];
      const double peak = 100 * (3 - 2 * std::cos(phi * degree));
      EXPECT_NEAR(body["peak_reaction_N"], peak, allowed * peak)
          << phi << ' ' << tolerance;
    }
  }
}

// A door that a constant moment stops: m g f r of the washer and 2 F f rho
// /sqrt(1 + f^2) of the pins, whose contacts are nearly lines. What the pins
// carry beside the weight's couple is 1e-4 of it.
TEST(SeparationMotion, DoorStopsAsItsWasherAndPinsSay) {
  const ProgramFolder folder;
  const json door = run_json(folder, "data/cases/door.toml");
  const double weight = 25 * 9.81, couple = weight * 0.4 / 1.5;
  const double arm =
      2.0 / 3 * (12e-3 * 12e-3 + 12e-3 * 6e-3 + 6e-3 * 6e-3) / (12e-3 + 6e-3);
  const double moment =
      0.2 * weight * arm + 2 * couple * 0.1 * 6e-3 / std::sqrt(1.01);
  const double inertia = 25 * ((0.64 + 0.0016) / 12 + 0.16);
  const double rate = 20 * degree;
  ASSERT_EQ(door["events"].size(), 1U);
  EXPECT_EQ(door["events"][0]["what"], "comes to rest");
  EXPECT_NEAR(door["events"][0]["time_s"].get<double>(),
              inertia * rate / moment, 1e-3);
  EXPECT_NEAR(door["bodies"][0]["work_of_friction_J"].get<double>(),
              inertia * rate * rate / 2, 1e-6);
  EXPECT_EQ(door["bodies"][0]["mode_at_end"], "resting");
}

// Every peak of joints that slide and turn, against a run with steps about 12
// times shorter.
TEST(SeparationMotion, PeaksAreThoseOfShortSteps) {
  const ProgramFolder folder;
  folder.write("short.toml", exchanged(sample_case("platform"), "[run]\n",
                                       "[run]\nlongest_step = 0.01\n"));
  const json one = run_json(folder, "data/cases/platform.toml")["bodies"];
  const json other = run_json(folder, "short.toml")["bodies"];
  const auto compare = [](const json& a, const json& b, const char* key) {
    const double exact = b[key];
    EXPECT_NEAR(a[key], exact, 1e-7 * exact) << key;
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

}  // namespace
}  // namespace contact::test::program_motion_test
