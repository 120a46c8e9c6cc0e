// Torsion springs, springs between bodies and torque margins of cases.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "libcontact/base/units.hpp"
#include "separation/case/case_reader.hpp"
#include "separation/results/run.hpp"
#include "separation/simulation/torque_margin.hpp"
#include "support/toml_text.hpp"

namespace contact::test::torque_margin_test {
namespace {

using separation::Case;
using separation::FrictionChoice;
using separation::Outcome;
using separation::parse_case;
using separation::Rows;
using separation::torque_margin;
using std::numbers::pi;

const std::string begin = R"(
name = "springs"
run = { end_time_s = 10, output_step_s = 1, relative_tolerance = 1e-12, absolute_tolerance = 1e-13 }
[carrier]; name = "ground"; fixed = true
[[body]]; name = "boom"; mass_kg = 1; principal_inertia_kg_m2 = [15, 15, 15]
)"_toml;

double value(const Outcome& outcome, std::size_t row,
             const std::string& column) {
  const Rows& rows = outcome.memory.rows;
  return rows.at(row, rows.column(column));
}

// J 15, k 8, free 20 deg, preload 0.6, c 3 from -60 deg at rest: a damped
// oscillation about 24.297 deg.
TEST(Torsion, IsADampedOscillation) {
  const Outcome outcome = separation::run_case(parse_case(begin + R"(
start = { angle_deg = -60 }; hinge = { kind = "axis", axis = [0, 0, 1] }
[[force]]; name = "spring"; kind = "torsion"; body = "boom"
stiffness_N_m_per_rad = 8; free_angle_deg = 20; preload_N_m = 0.6; damping_N_m_s_per_rad = 3
)"_toml,
                                                          "c.toml"),
                                               {});
  ASSERT_EQ(outcome.failure, "");
  EXPECT_NEAR(value(outcome, 1, "boom.angle_deg"), -39.85417873934, 1e-8);
  EXPECT_NEAR(value(outcome, 5, "boom.angle_deg"), 72.98950278062, 1e-8);
  EXPECT_NEAR(value(outcome, 10, "boom.angle_deg"), 2.79415273550, 1e-8);
  // The damper dissipates exactly the missing energy of the spring.
  const double turn = 80 * degree;
  EXPECT_NEAR(value(outcome, 0, "energy.springs_J"),
              0.6 * turn + 4 * turn * turn, 1e-12);
  EXPECT_NEAR(value(outcome, 10, "energy.balance_J"), 0, 1e-9);
}

// Without damping the spring stores the work done, whether it is given by
// numbers or by a table, which is constant beyond its rows.
TEST(Torsion, EnergyIsKept) {
  for (const std::string spring :
       {"stiffness_N_m_per_rad = 2\nfree_angle_deg = 10\n",
        "angle_deg = [-40, -5, 0, 30]\nmoment_N_m = [6, 1, -0.5, -2]\n"}) {
    const Outcome outcome = separation::run_case(
        parse_case(begin +
                       "start = { angle_deg = -60 }\n"
                       "hinge = { kind = \"axis\", axis = [0, 0, 1] }\n"
                       "[[force]]\nname = \"spring\"\nkind = \"torsion\"\n"
                       "body = \"boom\"\n" +
                       spring,
                   "c.toml"),
        {});
    ASSERT_EQ(outcome.failure, "");
    const auto sum = [&](std::size_t row) {
      return value(outcome, row, "energy.kinetic_J") +
             value(outcome, row, "energy.springs_J");
    };
    for (std::size_t row = 1; row < outcome.memory.rows.size(); ++row) {
      EXPECT_NEAR(sum(row), sum(0), 1e-8);
    }
  }
}

// Two bodies of a carrier that floats, drawn together by a spring between them:
// momentum stays 0, and both are where the reduced mass says.
TEST(Spring, JoinsAnyTwoBodies) {
  const Outcome outcome = separation::run_case(parse_case(R"(
name = "pair"
run = { end_time_s = 2, output_step_s = 1, relative_tolerance = 1e-12, absolute_tolerance = 1e-13 }
[carrier]; name = "bus"; mass_kg = 10; principal_inertia_kg_m2 = [1, 1, 1]
start = { position_m = [0, 100, 0] }
[[body]]; name = "a"; mass_kg = 2; principal_inertia_kg_m2 = [1, 1, 1]
[[body]]; name = "b"; mass_kg = 3; principal_inertia_kg_m2 = [1, 1, 1]; start = { position_m = [4, 0, 0] }
[[force]]; name = "spring"; kind = "spring"; body = "a"; point_m = [0, 0, 0]
other_body = "b"; other_point_m = [0, 0, 0]; stiffness_N_per_m = 12; free_length_m = 3
)"_toml,
                                                          "c.toml"),
                                               {});
  ASSERT_EQ(outcome.failure, "");
  const double w = std::sqrt(12 / 1.2);
  for (const std::size_t row : {1u, 2u}) {
    const double stretch = std::cos(w * static_cast<double>(row));
    EXPECT_NEAR(value(outcome, row, "b.x_m"), 2.4 + 0.4 * (3 + stretch), 1e-9);
    EXPECT_NEAR(value(outcome, row, "a.x_m"), 2.4 - 0.6 * (3 + stretch), 1e-9);
    EXPECT_NEAR(value(outcome, row, "bus.y_m"), 100, 1e-12);
  }
}

const std::string margin = R"(
start = { angle_deg = -90 }
[body.hinge]; kind = "axis"; axis = [0, 0, 1]
torque_margin = { to_deg = 0 }
[[force]]; name = "drive"; kind = "torsion"; body = "boom"; stiffness_N_m_per_rad = 0.4; preload_N_m = 0.5
)"_toml;

// Drive 0.5 + 0.4 (-phi), resist 0.17 + 0.03 (-phi): 0.5/0.17, at 0. The other
// way round what resisted drives.
TEST(TorqueMargin, OfTwoLines) {
  const std::string text =
      begin + margin +
      fmt::format(
          "[[force]]\nname = \"harness\"\nkind = \"torsion\"\n"
          "body = \"boom\"\nstarts_at_s = 5\nangle_deg = [-90, 0]\n"
          "moment_N_m = [{}, -0.17]\n",
          -0.17 - 0.03 * pi / 2);
  const auto least =
      torque_margin(parse_case(text, "c.toml"), 0, FrictionChoice::full);
  EXPECT_NEAR(least.ratio, 2.941176470588, 1e-12);
  EXPECT_EQ(least.angle, 0);
  std::string weighed = text;
  weighed.insert(weighed.find("to_deg"), "other_factor = 1.2, ");
  EXPECT_NEAR(
      torque_margin(parse_case(weighed, "c.toml"), 0, FrictionChoice::full)
          .ratio,
      0.5 / 0.17 / 1.2, 1e-12);
}

// ECSS-E-ST-33-01C multiplies a driving spring by 0.8 and a harness by 3, or by
// 1.5 if it was measured; NASA-STD-5017B by 3, 2.5 or 2. Factors in the file
// have priority.
TEST(TorqueMargin, WeighsAsStandards) {
  const struct {
    const char* keys;
    double factor;
  } rows[] = {{"\"ecss_theoretical\"", 0.8 / 3},
              {"\"ecss_measured\"", 0.8 / 1.5},
              {"\"nasa_analysis\"", 1 / 3.},
              {"\"nasa_development\"", 1 / 2.5},
              {"\"nasa_acceptance\"", 1 / 2.},
              {"\"ecss_measured\", other_factor = 1.2", 0.8 / 1.2},
              {"\"ecss_measured\", spring_factor = 1", 1 / 1.5}};
  for (const auto& [keys, factor] : rows) {
    std::string text = begin + margin +
                       "[[force]]\nname = \"harness\"\nkind = \"torsion\"\n"
                       "body = \"boom\"\nangle_deg = [-90, 0]\n"
                       "moment_N_m = [-0.17, -0.17]\n";
    text.insert(text.find("to_deg"), fmt::format("standard = {}, ", keys));
    EXPECT_NEAR(
        torque_margin(parse_case(text, "c.toml"), 0, FrictionChoice::full)
            .ratio,
        0.5 / 0.17 * factor, 1e-12)
        << keys;
  }
}

// Smallest between the nodes of the sweep: at a row of a table, its corner.
TEST(TorqueMargin, InsideTheWay) {
  const auto least = torque_margin(parse_case(begin + margin + R"(
[[force]]; name = "cable"; kind = "torsion"; body = "boom"; angle_deg = [-80, -37.123, -30]; moment_N_m = [-0.1, -0.6, -0.1]
)"_toml,
                                              "c.toml"),
                                   0, FrictionChoice::full);
  const double at = -37.123 * degree;
  EXPECT_NEAR(least.angle, at, 1e-12);
  EXPECT_NEAR(least.ratio, (0.5 - 0.4 * at) / 0.6, 1e-12);
}

// On the ground a boom that lifts its weight: weight and the friction of its
// pin under it resist, here f0 m g r, but for the shape of the pressure.
TEST(TorqueMargin, CountsWeightAndFriction) {
  std::string text = begin + R"(
com_m = [0.5, 0, 0]
[body.hinge]; kind = "axis"; axis = [0, 0, 1]; torque_margin = { from_deg = -60, to_deg = 40 }
[[body.hinge.joint]]; file = ")"_toml +
                     std::string(CONTACT_DATA_DIR) +
                     R"(/joints/pin_joint.toml"
[[force]]; name = "motor"; kind = "motor"; body = "boom"; moment_N_m = 20
)"_toml;
  text.insert(text.find("run ="), "gravity_m_per_s2 = [0, -9.81, 0]\n");
  const Case c = parse_case(text, "c.toml");
  const auto ideal = torque_margin(c, 0, FrictionChoice::ideal);
  EXPECT_NEAR(ideal.ratio, 20 / (9.81 * 0.5), 1e-12);
  EXPECT_NEAR(ideal.angle, 0, 1e-7);
  const auto full = torque_margin(c, 0, FrictionChoice::full);
  const double friction = 20 / full.ratio - 9.81 * 0.5;
  const double textbook = 0.1 * 9.81 * 0.02;
  EXPECT_GT(friction, textbook * 0.99);
  EXPECT_LT(friction, textbook * 1.3);
  // A motor is no spring; weight counts as another resisting moment.
  std::string weighed = text;
  weighed.insert(weighed.find("from_deg"),
                 "standard = \"ecss_theoretical\", "
                 "other_factor = 1, ");
  EXPECT_NEAR(
      20 / torque_margin(parse_case(weighed, "c.toml"), 0, FrictionChoice::full)
               .ratio,
      9.81 * 0.5 + 3 * friction, 1e-9);
  // Equals the result of a slow motion there.
  Case slow = c;
  slow.bodies[0].start.angle = full.angle;
  slow.bodies[0].start.angle_rate = 1e-9;
  slow.end_time = 1e-9;
  slow.forces.clear();
  slow.bodies[0].rigid.inertia *= 1e9;  // hardly accelerates
  const separation::Run run(slow, {});
  EXPECT_NEAR(run.sample().hinge(0).friction_moment.norm(), friction, 1e-8);
}

// What a margin lacks: enough of it for its standard, friction of joints that
// carry no load, anything that resists.
TEST(TorqueMargin, SaysWhatItLacks) {
  const auto notes = [](std::string text,
                        FrictionChoice friction = FrictionChoice::full) {
    text.insert(text.find("to_deg"), "standard = \"ecss_theoretical\", ");
    const Case c = parse_case(text, "c.toml");
    return separation::margin_notes(*c.bodies[0].hinge.margin,
                                    torque_margin(c, 0, friction));
  };
  const std::string harness = R"(
[[force]]; name = "harness"; kind = "torsion"; body = "boom"; angle_deg = [-90, 0]; moment_N_m = [-0.17, -0.17]
)"_toml;
  EXPECT_EQ(notes(begin + margin),
            std::vector<std::string>{"is infinite: nothing resists"});
  EXPECT_EQ(notes(begin + margin + harness),
            std::vector<std::string>{
                "is 0.7843 at 0 deg: ECSS-E-ST-33-01C requires 2"});
  std::string joint = margin;
  joint.insert(joint.find("[[force]]"),
               fmt::format("[[body.hinge.joint]]\nfile = \"{}\"\n",
                           CONTACT_DATA_DIR "/joints/pin_joint.toml"));
  EXPECT_EQ(notes(begin + joint + harness).back(),
            "contains no friction of joints, which carry no load at rest: add "
            "the friction in operation as a resisting moment");
  // Joints that are taken as ideal lack nothing.
  EXPECT_EQ(notes(begin + joint + harness, FrictionChoice::ideal).size(), 1u);
}

}  // namespace
}  // namespace contact::test::torque_margin_test
