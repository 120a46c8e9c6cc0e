// Whole runs of hinge-separation against closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "libcontact/base/units.hpp"
#include "libcontact/files/joint_file.hpp"
#include "separation/case/case_reader.hpp"
#include "separation/results/run.hpp"
#include "separation/results/summary.hpp"
#include "support/numbers.hpp"
#include "support/toml_text.hpp"

namespace contact::test::run_test {
namespace {

using Eigen::Vector3d;
using separation::Case;
using separation::Outcome;
using separation::parse_case;
using separation::Rows;
using separation::run_case;

const std::string pin_joint = CONTACT_DATA_DIR "/joints/pin_joint.toml";
const std::string pressed_joint =
    CONTACT_DATA_DIR "/joints/lined_bush_pressed.toml";
const std::string ball_joint =
    CONTACT_DATA_DIR "/joints/spherical_plain_bearing_infinite.toml";

double value(const Rows& rows, std::size_t row, const std::string& column) {
  return rows.at(row, rows.column(column));
}

// NAMEx_UNIT, NAMEy_UNIT and NAMEz_UNIT.
Vector3d vector(const Rows& rows, std::size_t row, const std::string& name,
                const std::string& unit) {
  return {value(rows, row, name + "x_" + unit),
          value(rows, row, name + "y_" + unit),
          value(rows, row, name + "z_" + unit)};
}

// A balanced wheel of 20 kg and 2 kg m^2 on a horizontal pin along y, on a
// carrier that is turned and held. Its reaction is its weight, so the friction
// moment on it is constant, against its turn.
Case wheel(const std::string& joint = pin_joint, double weight = 10) {
  return parse_case(R"(
name = "wheel"
gravity_m_per_s2 = [0, 0, -)" +
                        std::to_string(weight) + R"(]
run = { end_time_s = 0.5, output_step_s = 0.01 }
[carrier]; name = "base"; mass_kg = 100; principal_inertia_kg_m2 = [1, 1, 1]
start = { rotation_deg = [0, 0, 90] }
drive = { acceleration_m_per_s2 = [0, 0, 0] }
[[body]]; name = "wheel"; mass_kg = 20; principal_inertia_kg_m2 = [2, 3, 3]
start = { angle_deg = 20, rate_deg_per_s = 200 }
[body.hinge]; kind = "axis"; axis = [1, 0, 0]; carrier_point_m = [1, 2, 3]
zero_rotation_deg = [10, 0, 0]
[[body.hinge.joint]]
file = ")"_toml + joint +
                        "\"\n",
                    "c.toml");
}

// Bodies hang on pins that are level and without end.
TEST(ReliefOfCases, IsLeftOutAndSaysSo) {
  const Case c = wheel(CONTACT_DATA_DIR "/joints/relieved_bush.toml");
  const separation::HingeJoint& joint = c.bodies[0].hinge.joints[0];
  EXPECT_TRUE(joint.model.is_endless());
  EXPECT_TRUE(std::ranges::any_of(
      joint.contact().validity_notes(), [](const std::string& note) {
        return note.starts_with("the relief of the ends is ignored");
      }));
  EXPECT_EQ(run_case(c, {}).failure, "");
}

TEST(HistoryVectors, ActOnTheBodyAndStandInInertialAxes) {
  const Outcome outcome = run_case(wheel(), {});
  ASSERT_EQ(outcome.failure, "");
  const Rows& rows = outcome.memory.rows;
  const double first = value(rows, 0, "wheel.friction_moment_N_m");
  ASSERT_GT(first, 0.3);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_GT(value(rows, i, "wheel.rate_deg_per_s"), 0);
    // To rounding and the tolerance of the outer loop.
    const Vector3d force = vector(rows, i, "wheel.reaction_", "N");
    EXPECT_LE((force - Vector3d(0, 0, 200)).norm(), 200e-12) << force;
    const Vector3d moment = vector(rows, i, "wheel.friction_moment_", "N_m");
    EXPECT_LE((moment - Vector3d(0, -first, 0)).norm(), 1e-9 * first) << moment;
  }
}

// Friction takes a positive energy out of the motion.
TEST(FrictionWork, IsPositiveAndWhatTheMotionLoses) {
  const Case c = wheel();
  const Outcome outcome = run_case(c, {});
  const Rows& rows = outcome.memory.rows;
  const double moment = value(rows, 0, "wheel.friction_moment_N_m");
  const auto turned = [&](std::size_t row) {
    return (value(rows, row, "wheel.angle_deg") - 20) * degree;
  };
  double before = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double work = value(rows, i, "wheel.friction_work_J");
    EXPECT_GT(work, before);
    before = work;
    // To the tolerance of the steps, 1e-8 for angles.
    EXPECT_NEAR(work, moment * turned(i), 1e-8 * moment);
    EXPECT_NEAR(
        work,
        value(rows, 0, "energy.kinetic_J") - value(rows, i, "energy.kinetic_J"),
        1e-8 * moment);
    EXPECT_EQ(work, value(rows, i, "energy.dissipated_J"));
  }
  EXPECT_EQ(separation::summary(c, outcome)["bodies"][0]["work_of_friction_J"],
            before);
}

// A wheel on a bush with interference turns against the same moment under its
// weight, which leaves the contact closed, and without any.
TEST(PressedHinge, BrakesWithoutLoad) {
  const double expected =
      read_joint(pressed_joint).contact().unloaded_moment(0);
  for (const double weight : {10., 0.}) {
    const Outcome outcome = run_case(wheel(pressed_joint, weight), {});
    ASSERT_EQ(outcome.failure, "");
    const Rows& rows = outcome.memory.rows;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_NEAR(value(rows, i, "wheel.friction_moment_N_m"), expected,
                  1e-9 * expected);
      EXPECT_NEAR(value(rows, i, "wheel.reaction_N"), 20 * weight, 1e-9);
    }
    EXPECT_LE(outcome.memory.largest_drift,
              1e-8 * outcome.memory.largest_energy);
  }
}

// A pendulum whose bush lifts off and closes as it swings.
TEST(PressedHinge, SwingsThroughLiftOff) {
  const Case c = parse_case(R"(
name = "pendulum"; gravity_m_per_s2 = [0, 0, -10]
[run]; end_time_s = 6; output_step_s = 0.01; relative_tolerance = 1e-10
absolute_tolerance = 1e-9
[carrier]; name = "base"; mass_kg = 100; principal_inertia_kg_m2 = [1, 1, 1]
drive = { acceleration_m_per_s2 = [0, 0, 0] }
[[body]]; name = "arm"; mass_kg = 200; principal_inertia_kg_m2 = [2, 3, 3]
com_m = [0, 0, -0.3]; start = { angle_deg = 80 }
[body.hinge]; kind = "axis"; axis = [1, 0, 0]
[[body.hinge.joint]]
file = ")"_toml + pressed_joint +
                                "\"\n",
                            "c.toml");
  const double lift_off = read_joint(pressed_joint).contact().lift_off_force();
  const Outcome outcome = run_case(c, {});
  ASSERT_EQ(outcome.failure, "");
  const Rows& rows = outcome.memory.rows;
  double least = INFINITY;
  double most = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double force = value(rows, i, "arm.reaction_N");
    least = std::min(least, force);
    most = std::max(most, force);
  }
  EXPECT_LT(least, 0.5 * lift_off);
  EXPECT_GT(most, 1.5 * lift_off);
  // Steps over a kink: 2e-8 at these tolerances, 7e-7 at the usual ones.
  EXPECT_LE(outcome.memory.largest_drift, 1e-7 * outcome.memory.largest_energy);
}

TEST(HistoryVectors, HaveTheLengthsOfTheOtherColumns) {
  for (const std::string name : {"soyuz", "platform"}) {
    Case c = separation::read_case(CONTACT_DATA_DIR "/cases/" + name + ".toml");
    c.clearance.clear();
    const Outcome outcome = run_case(c, {});
    const Rows& rows = outcome.memory.rows;
    double largest_lock = 0;
    for (const separation::Body& body : c.bodies) {
      const std::string column = separation::column_name(body.rigid.name);
      const auto expect_length = [&](std::size_t row, const std::string& what,
                                     const std::string& unit) {
        const double length = value(rows, row, column + what + "_" + unit);
        EXPECT_NEAR(vector(rows, row, column + what + "_", unit).norm(), length,
                    1e-13 * length);
        return length;
      };
      for (std::size_t i = 0; i < rows.size(); ++i) {
        expect_length(i, ".reaction", "N");
        expect_length(i, ".friction_moment", "N_m");
        largest_lock =
            std::max(largest_lock, expect_length(i, ".lock_reaction", "N"));
      }
    }
    EXPECT_GT(largest_lock, 0) << name;
  }
}

// A stone alone in space, and two of them: thrown, pushed and turning about a
// principal axis.
TEST(WithoutHinges, BodiesFlyOnParabolas) {
  const std::string file = R"(
name = "stones"; gravity_m_per_s2 = [0, 0, -10]; run = { end_time_s = 2 }
[carrier]; name = "stone"; mass_kg = 2; principal_inertia_kg_m2 = [1, 2, 3]
[carrier.start]; velocity_m_per_s = [1, 2, 3]
angular_velocity_rad_per_s = [0, 0, 0.3]
[[force]]; name = "push"; body = "stone"; kind = "applied"; axes = "inertial"
force_N = [0, 4, 0]
)"_toml;
  const std::string other = R"(
[[body]]; name = "other"; mass_kg = 5; principal_inertia_kg_m2 = [1, 1, 1]
start = { position_m = [9, 0, 0], velocity_m_per_s = [0, 1, 0] }
)"_toml;
  for (const std::string& more : {std::string(), other}) {
    const Case c = parse_case(file + more, "c.toml");
    const Outcome outcome = run_case(c, {});
    ASSERT_EQ(outcome.failure, "");
    const Rows& rows = outcome.memory.rows;
    const std::size_t last = rows.size() - 1;
    EXPECT_EQ(last, 200U);
    const auto place = [&](const std::string& body) {
      return vector(rows, last, body + ".", "m");
    };
    // Parabolas are exact but for rounding.
    EXPECT_LE((place("stone") - Vector3d(2, 8, -14)).norm(), 1e-12);
    EXPECT_NEAR(2 * std::acos(value(rows, last, "stone.qw")), 0.6, 1e-8);
    EXPECT_LE(outcome.memory.largest_drift, 1e-8 * 300);
    EXPECT_EQ(separation::summary(c, outcome)["bodies"].size(),
              more.empty() ? 0U : 1U);
    if (more.empty()) continue;
    EXPECT_LE((place("other") - Vector3d(9, 2, -20)).norm(), 1e-12);
  }
}

// Balls of 0.5 m that fly past each other 2 m apart, and a rod of 4 m that
// turns past a ball: with one output, at the end, the smallest distance is
// between looks.
TEST(SmallestClearance, BetweenTheLooks) {
  const auto smallest =
      [](const std::string& start, const std::string& rod, bool rows) {
        const Case c =
            parse_case(
                R"(
name = "past"; run = { end_time_s = 5, output_step_s = 5 }
[carrier]; name = "a"; mass_kg = 1; principal_inertia_kg_m2 = [1, 1, 1]
shape = [{ kind = "capsule", from_m = [0, 0, 0], to_m = [0, 0, 0], radius_m = 0.5 }]
[[body]]; name = "b"; mass_kg = 1; com_m = [0, 0, 0]
principal_inertia_kg_m2 = [1, 1, 1]
shape = [{ kind = "capsule", from_m = [)"_toml +
                    rod + R"(, 0, 0], to_m = [-)" + rod +
                    R"(, 0, 0], radius_m = 0.5 }]
start = )" + start + '\n',
                "past.toml");
        separation::RunOptions options;
        options.rows = rows;
        return run_case(c, options).memory.pairs[0];
      };
  for (const bool rows : {false, true}) {
    const auto past =
        smallest("{ position_m = [-10, 2, 0], velocity_m_per_s = [4, 0, 0] }",
                 "0", rows);
    // The accuracy of distances; the time goes as its root.
    EXPECT_NEAR(past.smallest, 1, 1e-8);
    EXPECT_NEAR(past.time, 2.5, 1e-4);
    // Its end points at the ball after 60 of the 100 deg.
    const auto turning = smallest(
        "{ position_m = [0, 4, 0], rotation_deg = [0, 0, 30], "
        "angular_velocity_deg_per_s = [0, 0, 20] }",
        "2", rows);
    EXPECT_NEAR(turning.smallest, 1, 1e-8);
    EXPECT_NEAR(turning.time, 3, 1e-4);
  }
}

// A dart that turns across the wind through a lobe of its coefficient: a
// triangle of 0.1 to 5 deg that takes the same work from it.
TEST(AerodynamicTables, NarrowLobesTakeTheirWork) {
  for (const double width : {0.1, 1., 5.}) {
    const double least = -100 / width;
    const Case c = parse_case(
        R"(
name = "lobe"; run = { end_time_s = 3, output_step_s = 0.1 }
[carrier]; name = "dart"; mass_kg = 10
principal_inertia_kg_m2 = [15, 15, 15]
[carrier.start]; rotation_deg = [0, 0, 10]
angular_velocity_deg_per_s = [0, 0, 30]
[[force]]; name = "air"; body = "dart"; kind = "aerodynamic"
axis = [1, 0, 0]; flow = [-1, 0, 0]; dynamic_pressure_Pa = 1
reference_area_m2 = 1
)"_toml + fmt::format("angle_deg = [0, 40, {}, {}, 180]\n"
                      "moment = [0, 0, {}, 0, 0]\n",
                      40 + width / 2, 40 + width, least),
        "lobe.toml");
    const Outcome outcome = run_case(c, {});
    ASSERT_EQ(outcome.failure, "");
    const double work = least * width * degree / 2;
    const double rate = std::sqrt(900 * degree * degree + 2 * work / 15);
    const Rows& rows = outcome.memory.rows;
    // By the steps' tolerances.
    EXPECT_NEAR(value(rows, rows.size() - 1, "dart.wz_rad_per_s"), rate, 1e-7)
        << width;
  }
}

// A gust whose pressure rises and falls through a table that has a force in one
// narrow band of pressures only: it gives the impulse of that band twice.
TEST(AerodynamicTables, NarrowBandsOfPressureGiveTheirImpulse) {
  for (const double width : {0.05, 1., 20.}) {  // Pa, about 40 Pa
    const Case c = parse_case(
        R"(
name = "gust"; run = { end_time_s = 30, output_step_s = 30 }
[carrier]; name = "dart"; mass_kg = 10
principal_inertia_kg_m2 = [15, 15, 15]
[[force]]; name = "air"; body = "dart"; kind = "aerodynamic"; starts_at_s = 3
axis = [1, 0, 0]; flow = [-1, 0, 0]; reference_area_m2 = 1
time_s = [0, 10, 10, 15, 20]; dynamic_pressure_Pa = [0, 100, 100, 0, 0]
angle_deg = [0, 180]
)"_toml + fmt::format("table_pressure_Pa = [1, {}, 40, {}]\n"
                      "axial = [[0, 0], [0, 0], [{}, {}], [0, 0]]\n",
                      40 - width / 2, 40 + width / 2, 1 / width, 1 / width),
        "gust.toml");
    const Outcome outcome = run_case(c, {});
    ASSERT_EQ(outcome.failure, "");
    // The integral of q c over q is 40/2 by its symmetry; at 10 and 20 Pa/s.
    const double impulse = 20 / 10. + 20 / 20.;
    const Rows& rows = outcome.memory.rows;
    // By the steps' tolerances.
    EXPECT_NEAR(value(rows, rows.size() - 1, "dart.vx_m_per_s"), -impulse / 10,
                1e-7)
        << width;
  }
}

// A pusher that begins behind its stroke on a fast body does the work of the
// first force up to the stroke, and then the work of the ramp.
TEST(Pusher, ShortStrokesTakeTheirWork) {
  for (const double stroke : {1e-4, 1e-2}) {
    const Case c = parse_case(
        R"(
name = "kick"; run = { end_time_s = 3, output_step_s = 3 }
[carrier]; name = "base"; fixed = true
[[body]]; name = "pin"; mass_kg = 2; com_m = [0, 0, 0]
principal_inertia_kg_m2 = [1, 1, 1]
start = { position_m = [-1, 0, 0], velocity_m_per_s = [1, 0, 0] }
[[force]]; name = "push"; body = "pin"; kind = "pusher"; point_m = [0, 0, 0]
carrier_point_m = [0, 0, 0]; direction = [1, 0, 0]; first_force_N = 1
)"_toml + fmt::format("stroke_m = {}\nlast_force_N = {}\n", stroke, 2 / stroke),
        "kick.toml");
    const Outcome outcome = run_case(c, {});
    ASSERT_EQ(outcome.failure, "");
    const double work = 1 + (1 + 2 / stroke) / 2 * stroke;
    const Rows& rows = outcome.memory.rows;
    EXPECT_NEAR(value(rows, rows.size() - 1, "pin.vx_m_per_s"),
                std::sqrt(1 + work), 1e-7)
        << stroke;
  }
}

// Two capsules of the radii 0.3 and 0.2 along z, b flying along x past a at
// some speed and at some distance of their axes; turning about its own, too. On
// straight ways the distance is sqrt(x^2 + y^2) - 0.5.
struct FastPassage {
  double speed;  // m/s
  double row;    // s
};
class FastPassages : public testing::TestWithParam<FastPassage> {};
INSTANTIATE_TEST_SUITE_P(
    Speeds, FastPassages,
    testing::Values(FastPassage{1, 1}, FastPassage{1, 0.01},
                    FastPassage{30, 0.05}, FastPassage{100, 0.5},
                    FastPassage{1000, 0.5}, FastPassage{1000, 0.01},
                    FastPassage{1e4, 1}, FastPassage{1e4, 0.01}));

TEST_P(FastPassages, HaveTheirSmallestDistance) {
  const auto [speed, row] = GetParam();
  constexpr double passes_at = 1.2345678;  // s
  for (const double beside : {0., 0.4, 0.4999, 0.5001, 0.7, 3.}) {
    const std::string text =
        R"(
name = "fly-by"
[carrier]; name = "a"; mass_kg = 100; principal_inertia_kg_m2 = [10, 10, 10]
shape = [{ kind = "capsule", from_m = [0, 0, -0.5], to_m = [0, 0, 0.5], radius_m = 0.3 }]
[[body]]; name = "b"; mass_kg = 50; principal_inertia_kg_m2 = [5, 5, 5]
shape = [{ kind = "capsule", from_m = [0, 0, -0.1], to_m = [0, 0, 0.1], radius_m = 0.2 }]
)"_toml +
        fmt::format(
            "[run]\nend_time_s = 2\noutput_step_s = {}\n[body.start]\n"
            "position_m = [{}, {}, 0]\nvelocity_m_per_s = [{}, 0, 0]\n"
            "angular_velocity_rad_per_s = [0, 0, {}]\n",
            row, -speed * passes_at, beside, speed, speed < 200 ? 0.5 : 0);
    const auto pair =
        run_case(parse_case(text, "fly-by.toml"), {}).memory.pairs[0];
    // Accuracy of the distances, and of places some 1e4 m away.
    constexpr double accuracy = 1e-8;
    if (beside > 0.5) {
      EXPECT_NEAR(pair.smallest, beside - 0.5, accuracy) << beside;
      continue;
    }
    const double before = std::sqrt(0.25 - beside * beside) / speed;
    // Gaps of up to 1e-8 of the size, which is the distance of the centres and
    // some, may be taken for a touch.
    const double near = 1e-8 + 4e-8 / speed;
    EXPECT_EQ(pair.smallest, 0) << beside;
    EXPECT_NEAR(pair.overlap_from, passes_at - before, near) << beside;
    EXPECT_NEAR(pair.overlap_to, passes_at + before, near) << beside;
    EXPECT_EQ(pair.time, pair.overlap_from);
  }
}

// The time of a touch differs from the time of the next row.
TEST(SmallestClearance, TouchesHaveTheirTime) {
  const Case c = parse_case(R"(
name = "re-contact"; run = { end_time_s = 4, output_step_s = 0.1 }
[carrier]; name = "a"; mass_kg = 100; principal_inertia_kg_m2 = [10, 10, 10]
shape = [{ kind = "capsule", from_m = [0, 0, 0], to_m = [1, 0, 0], radius_m = 0.3 }]
[[body]]; name = "b"; mass_kg = 50; principal_inertia_kg_m2 = [5, 5, 5]
shape = [{ kind = "capsule", from_m = [0, 0, 0], to_m = [1, 0, 0], radius_m = 0.2 }]
start = { position_m = [0.2, 3, 0], velocity_m_per_s = [0, -2, 0] }
)"_toml,
                            "c.toml");
  for (const bool rows : {false, true}) {
    separation::RunOptions options;
    options.rows = rows;
    const auto pair = run_case(c, options).memory.pairs[0];
    EXPECT_EQ(pair.smallest, 0);
    EXPECT_NEAR(pair.time, 1.25, 1e-8);
    EXPECT_EQ(pair.overlap_from, pair.time);
    EXPECT_NEAR(pair.overlap_to, 1.75, 1e-8);
  }
}

// Forces that jump three times, at times that are not exact in doubles:
// momentum and position equal the table's integrals to rounding.
class TimeTables : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Integrators, TimeTables,
                         testing::Values("adaptive", "rk4"));

TEST_P(TimeTables, JumpsGiveTheImpulseOfTheTable) {
  const Case c = parse_case(R"(
name = "stone"
run = { end_time_s = 1.5, output_step_s = 0.05, integrator = ")" +
                                GetParam() + R"(" }
[carrier]; name = "stone"; mass_kg = 2; principal_inertia_kg_m2 = [1, 1, 1]
[[force]]; name = "push"; body = "stone"; kind = "applied"; starts_at_s = 0.1
time_s = [0, 0.2, 0.2, 0.7, 0.7, 1.1, 1.1]
force_N = [[3, 0, 0], [5, 0, 0], [-2, 0, 0], [-2, 0, 0], [7, 0, 0], [0, 0, 0],
           [1, 0, 0]]
)"_toml,
                            "c.toml");
  const Outcome outcome = run_case(c, {});
  ASSERT_EQ(outcome.failure, "");
  // Pieces: from, to, force at both ends.
  constexpr double pieces[][4] = {
      {0.1, 0.3, 3, 5}, {0.3, 0.8, -2, -2}, {0.8, 1.2, 7, 0}, {1.2, 9, 1, 1}};
  const Rows& rows = outcome.memory.rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double time = value(rows, i, "time_s");
    double impulse = 0;
    double moved = 0;  // times the mass
    for (const auto& [from, to, first, last] : pieces) {
      if (time <= from) break;
      const double t = std::min(time, to) - from;
      const double slope = (last - first) / (to - from);
      moved += impulse * t + first * t * t / 2 + slope * t * t * t / 6;
      impulse += first * t + slope * t * t / 2;
    }
    EXPECT_NEAR(value(rows, i, "stone.vx_m_per_s"), impulse / 2, 1e-13);
    EXPECT_NEAR(value(rows, i, "stone.x_m"), moved / 2, 1e-13);
  }
}

// A boom of 15 kg m^2 that a spring of 2 N m turns from rest at -90 deg over a
// hard spot of some width that ends at -20 deg: a triangle of the table down to
// `least`. The moment's work up to an angle, J.
constexpr double hard_spot_end = -20;
double hard_spot_work(double angle_deg, double width, double least) {
  const double from = (angle_deg - (hard_spot_end - width)) / width;
  const double share = std::clamp(from, 0., 1.);
  const double triangle =
      share < 0.5 ? 2 * share * share : 1 - 2 * (1 - share) * (1 - share);
  return 2 * (angle_deg + 90) * degree +
         (least - 2) * width * degree / 2 * triangle;
}

struct HardSpot {
  double width;  // deg
  double loss;   // J, of the pi J that the spring gives up to +0 deg
  const char* run;
  double accuracy;
};
constexpr const char* tight =
    "relative_tolerance = 1e-11\nabsolute_tolerance = 1e-11";
class HardSpots : public testing::TestWithParam<HardSpot> {};
// By adaptive steps as exact as their tolerance says; by fixed ones of 20 ms to
// their fourth order.
INSTANTIATE_TEST_SUITE_P(
    Widths, HardSpots,
    testing::Values(
        HardSpot{0.1, 0.5, "", 1e-7}, HardSpot{5, 2, "", 1e-7},
        HardSpot{0.1, 2, tight, 1e-8}, HardSpot{1, 0.5, tight, 1e-8},
        HardSpot{5, 2, tight, 1e-8}, HardSpot{20, 2, tight, 1e-8},
        HardSpot{20, 2, "integrator = \"rk4\"\nstep_s = 0.02", 1e-6},
        // It turns back in the spot, and at -90 deg, again and again.
        HardSpot{0.1, 4, tight, 1e-8}, HardSpot{1, 4, tight, 1e-8},
        HardSpot{5, 4, tight, 1e-8}, HardSpot{20, 4, tight, 1e-8}));

TEST_P(HardSpots, TakeTheirWork) {
  const auto& [width, loss, run, accuracy] = GetParam();
  const double least = 2 - loss / (width * degree / 2);
  const std::string text =
      R"(
name = "spot"
[carrier]; name = "g"; fixed = true
[[body]]; name = "boom"; mass_kg = 5; com_m = [1.5, 0, 0]
principal_inertia_kg_m2 = [0.01, 3.75, 3.75]; start = { angle_deg = -90 }
hinge = { kind = "axis", axis = [0, 0, 1] }
[[event]]; name = "open"; angle_deg = 0; breaks = "hinge"
[[force]]; name = "spring"; kind = "motor"; body = "boom"
)"_toml +
      fmt::format("angle_deg = [{}, {}, {}]\nmoment_N_m = [2, {}, 2]\n",
                  hard_spot_end - width, hard_spot_end - width / 2,
                  hard_spot_end, least) +
      fmt::format("[run]\nend_time_s = {}\noutput_step_s = 0.1\n{}\n",
                  loss > 3 ? 40 : 8, run);
  const Case c = parse_case(text, "spot.toml");
  const Outcome outcome = run_case(c, {});
  ASSERT_EQ(outcome.failure, "");
  const auto& release = outcome.memory.bodies[0].release;
  if (loss < 3) {
    const double rate = std::sqrt(2 * (pi - loss) / 15);
    EXPECT_NEAR(release.rate, rate, accuracy * rate);
    return;
  }
  EXPECT_EQ(release.time, separation::History::not_yet);
  const Rows& rows = outcome.memory.rows;
  int turns = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double angle = value(rows, i, "boom.angle_deg");
    const double rate = value(rows, i, "boom.rate_deg_per_s") * degree;
    EXPECT_NEAR(15 * rate * rate / 2, hard_spot_work(angle, width, least),
                accuracy * pi);
    if (i > 0) turns += rate * value(rows, i - 1, "boom.rate_deg_per_s") < 0;
  }
  EXPECT_GE(turns, 5);
}

// The carrier stays where it is, but for the rounding of dense output, and so
// does the energy.
void expect_fixed_carrier(const Outcome& outcome) {
  ASSERT_EQ(outcome.failure, "");
  const Rows& rows = outcome.memory.rows;
  const auto expect_same = [&](std::size_t row, const std::string& name,
                               const std::string& unit) {
    const Vector3d first = vector(rows, 0, name, unit);
    EXPECT_LE((vector(rows, row, name, unit) - first).norm(),
              1e-15 * first.norm());
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    expect_same(i, "ground.", "m");
    expect_same(i, "ground.v", "m_per_s");
    expect_same(i, "ground.w", "rad_per_s");
  }
  // Some 100 steps at tolerances of 1e-8.
  EXPECT_LE(outcome.memory.largest_drift, 1e-7 * outcome.memory.largest_energy);
}

// For hours, under gravity and turned so that rounding has its part in the
// forces: 1e-15 of them would make 5e-7 m.
TEST(FixedCarrier, DoesNotDrift) {
  const Outcome outcome = run_case(parse_case(R"(
name = "wheel"; gravity_m_per_s2 = [1, -2, -10]; run = { end_time_s = 3e4 }
[carrier]; name = "ground"; fixed = true
start = { position_m = [1, 2, 3], rotation_deg = [10, 20, 30] }
[[body]]; name = "wheel"; mass_kg = 4
principal_inertia_kg_m2 = [0.1, 0.5, 0.6]
hinge = { kind = "axis", axis = [0, 0, 1] }; start = { rate_deg_per_s = 1 }
)"_toml,
                                              "c.toml"),
                                   {});
  expect_fixed_carrier(outcome);
}

// On a pin along z, of a turned carrier; angle 0 is upwards, along y.
TEST(FixedCarrier, PhysicalPendulumOnAPin) {
  Case c = parse_case(R"(
name = "pendulum"; gravity_m_per_s2 = [0, -10, 0]; run = { end_time_s = 1 }
[carrier]; name = "ground"; fixed = true
start = { position_m = [1, 2, 3], rotation_deg = [0, 0, 90] }
[[body]]; name = "arm"; mass_kg = 4; com_m = [0.3, 0, 0]
principal_inertia_kg_m2 = [0.1, 0.5, 0.6]
hinge = { kind = "axis", axis = [0, 0, 1] }; start = { angle_deg = 120 }
)"_toml,
                      "c.toml");
  constexpr double mass = 4;
  constexpr double arm = 0.3;
  constexpr double stiffness = mass * 10 * arm / (0.6 + mass * arm * arm);
  const double first = 60 * degree;  // from hanging
  c.end_time =
      4 * std::comp_ellint_1(std::sin(first / 2)) / std::sqrt(stiffness);
  c.output_step = c.end_time / 200;
  const Outcome outcome = run_case(c, {});
  expect_fixed_carrier(outcome);
  const Rows& rows = outcome.memory.rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double angle = value(rows, i, "arm.angle_deg") * degree;
    const double from_hanging = angle - 180 * degree;
    const double square =
        2 * stiffness * (std::cos(from_hanging) - std::cos(first));
    const double acceleration = -stiffness * std::sin(from_hanging);
    const Vector3d along(-std::sin(angle), std::cos(angle), 0);
    const Vector3d across(-std::cos(angle), -std::sin(angle), 0);
    const Vector3d reaction =
        mass *
        (arm * (acceleration * across - square * along) - Vector3d(0, -10, 0));
    // Tolerances of the steps, some 100 of them.
    EXPECT_NEAR(std::pow(value(rows, i, "arm.rate_deg_per_s") * degree, 2),
                square, 1e-6);
    EXPECT_LE((vector(rows, i, "arm.reaction_", "N") - reaction).norm(), 1e-6);
    EXPECT_LE(
        (vector(rows, i, "arm.", "m") - Vector3d(1, 2, 3) - arm * along).norm(),
        1e-12);
  }
  // After a whole period.
  EXPECT_NEAR(value(rows, rows.size() - 1, "arm.angle_deg"), 120, 1e-6);
}

// On a ball, tilted by 30 deg and turning about the vertical at the rate at
// which it stays so.
TEST(FixedCarrier, ConicalPendulumOnABall) {
  constexpr double mass = 4;
  constexpr double arm = 0.3;
  const double tilt = 30 * degree;
  const double rate = std::sqrt(
      mass * 10 * arm / ((0.5 + mass * arm * arm - 0.1) * std::cos(tilt)));
  Case c = parse_case(R"(
name = "pendulum"; gravity_m_per_s2 = [0, 0, -10]; run = { end_time_s = 3 }
carrier = { name = "ground", fixed = true }
[[body]]; name = "arm"; mass_kg = 4; com_m = [0.3, 0, 0]
principal_inertia_kg_m2 = [0.1, 0.5, 0.5]; hinge = { kind = "ball" }
start = { rotation_deg = [0, 60, 0] }
)"_toml,
                      "c.toml");
  c.bodies[0].start.relative_angular_velocity =
      rate * Vector3d(-std::cos(tilt), 0, std::sin(tilt));
  const Outcome outcome = run_case(c, {});
  expect_fixed_carrier(outcome);
  const Rows& rows = outcome.memory.rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double turned = rate * value(rows, i, "time_s");
    const Vector3d out =
        arm * std::sin(tilt) * Vector3d(std::cos(turned), std::sin(turned), 0);
    const Vector3d place = out - Vector3d(0, 0, arm * std::cos(tilt));
    const Vector3d reaction = mass * (Vector3d(0, 0, 10) - rate * rate * out);
    // Tolerances of the steps, some 100 of them.
    EXPECT_LE((vector(rows, i, "arm.", "m") - place).norm(), 1e-7);
    EXPECT_LE((vector(rows, i, "arm.reaction_", "N") - reaction).norm(), 1e-5);
  }
}

// Bodies that swing, turn and come to rest on a carrier, with friction.
std::string shaken(const std::string& carrier) {
  std::string text = R"(
name = "bodies"
[run]; end_time_s = 4; relative_tolerance = 1e-11; absolute_tolerance = 1e-11
[carrier]; name = "ground"
)"_toml + carrier + R"(
[[body]]; name = "arm"; mass_kg = 40; com_m = [0.3, 0, 0]
principal_inertia_kg_m2 = [0.1, 0.5, 0.6]; start = { angle_deg = -60 }
[body.hinge]; kind = "axis"; axis = [0, 1, 0]; joint = [{ file = "PIN" }]
[[body]]; name = "wheel"; mass_kg = 40
principal_inertia_kg_m2 = [0.5, 0.5, 0.5]; start = { rate_deg_per_s = 30 }
[body.hinge]; kind = "axis"; axis = [0, 1, 0]; carrier_point_m = [0, -3, 0]
joint = [{ file = "PIN" }]
[[body]]; name = "bob"; mass_kg = 40; com_m = [0.3, 0, 0]
principal_inertia_kg_m2 = [0.1, 0.5, 0.6]
start = { rotation_deg = [0, 20, 0], angular_velocity_rad_per_s = [0, 0, 2] }
[body.hinge]; kind = "ball"; carrier_point_m = [0, 3, 0]
joint = [{ file = "BALL" }]
)"_toml;
  for (const auto& [word, file] :
       {std::pair("PIN", pin_joint), std::pair("BALL", ball_joint)}) {
    for (auto at = text.find(word); at != text.npos; at = text.find(word)) {
      text.replace(at, std::strlen(word), file);
    }
  }
  for (const std::string body : {"arm", "wheel", "bob"}) {
    text += "[[force]]\nname = \"weight of " + body + "\"\nbody = \"" + body +
            "\"\nkind = \"applied\"\naxes = \"inertial\"\n"
            "force_N = [0, 0, -400]\n";
  }
  return text;
}

// Under 1200 N and 1200 N m a carrier of 1e12 kg and 1e12 kg m^2 moves by
// 1e-8 m in 4 s and turns as much.
TEST(FixedCarrier, IsTheLimitOfAHeavyOne) {
  const auto run = [](const std::string& carrier) {
    return run_case(parse_case(shaken(carrier), "c.toml"), {});
  };
  const Outcome fixed = run("fixed = true");
  const Outcome heavy =
      run("mass_kg = 1e12\nprincipal_inertia_kg_m2 = [1e12, 1e12, 1e12]");
  expect_fixed_carrier(fixed);
  ASSERT_EQ(heavy.failure, "");
  const Rows& a = fixed.memory.rows;
  const Rows& b = heavy.memory.rows;
  ASSERT_EQ(a.columns, b.columns);
  ASSERT_EQ(a.size(), b.size());
  constexpr double moved = 1e-8;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (const std::string body : {"arm", "wheel", "bob"}) {
      EXPECT_EQ(value(a, i, body + ".mode"), value(b, i, body + ".mode"));
      EXPECT_NEAR(value(a, i, body + ".angle_deg"),
                  value(b, i, body + ".angle_deg"), moved / degree);
      const auto difference = [&](const std::string& name,
                                  const std::string& unit) {
        return (vector(a, i, body + name, unit) -
                vector(b, i, body + name, unit))
            .norm();
      };
      EXPECT_LE(difference(".", "m"), 3 * moved);
      // Forces are 1700 N and moments 3.3 N m at most.
      EXPECT_LE(difference(".reaction_", "N"), 1700 * moved);
      EXPECT_LE(difference(".friction_moment_", "N_m"), 3.3 * moved);
    }
  }
  const std::size_t last = a.size() - 1;
  EXPECT_EQ(value(a, 0, "wheel.mode"),
            static_cast<int>(multibody::HingeMode::sliding));
  EXPECT_EQ(value(a, last, "wheel.mode"),
            static_cast<int>(multibody::HingeMode::resting));
}

}  // namespace
}  // namespace contact::test::run_test
