// Cases with bodies on bodies: numbers from independent routes, copies, orders
// in the file, and cases with drawn numbers.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/files/toml_form.hpp"
#include "separation/case/case_reader.hpp"
#include "separation/case/form/case_form.hpp"
#include "separation/results/run.hpp"
#include "support/toml_text.hpp"

namespace contact::test::tree_test {
namespace {

using separation::Case;
using separation::Outcome;
using separation::parse_case;
using separation::Rows;
using separation::run_case;

const std::string rods_begin = R"(
name = "rods"; gravity_m_per_s2 = [0, 0, -9.81]
run = { end_time_s = 1, output_step_s = 0.5, relative_tolerance = 1e-12, absolute_tolerance = 1e-13 }
[carrier]; name = "ground"; fixed = true
)"_toml;
const std::string upper = R"(
[[body]]; name = "upper"; mass_kg = 1; com_m = [0.5, 0, 0]
inertia_kg_m2 = [[0, 0, 0], [0, 0.08333333333333333, 0], [0, 0, 0.08333333333333333]]
hinge = { kind = "axis", axis = [0, 1, 0] }
)"_toml;
const std::string lower = R"(
[[body]]; name = "lower"; mass_kg = 1; com_m = [0.5, 0, 0]
inertia_kg_m2 = [[0, 0, 0], [0, 0.08333333333333333, 0], [0, 0, 0.08333333333333333]]
hinge = { kind = "axis", axis = [0, 1, 0], on = "upper", parent_point_m = [1, 0, 0] }
)"_toml;

// Two rods of 1 m and 1 kg, one on the other, let go level: numbers by DOP853
// on the Lagrangian equations, to 1e-12. The error of the integration is below
// 1e-9 of them.
TEST(CaseTree, TwoRodsFall) {
  for (const bool lower_first : {false, true}) {
    const Outcome outcome = run_case(
        parse_case(rods_begin + (lower_first ? lower + upper : upper + lower),
                   "c.toml"),
        {});
    ASSERT_EQ(outcome.failure, "");
    const Rows& rows = outcome.memory.rows;
    const auto value = [&](std::size_t row, const char* column) {
      return rows.at(row, rows.column(column));
    };
    EXPECT_NEAR(value(0, "upper.acceleration_deg_per_s2"),
                12.612857142857143 / degree, 1e-9);
    EXPECT_NEAR(value(0, "lower.acceleration_deg_per_s2"),
                -16.817142857142857 / degree, 1e-9);
    EXPECT_NEAR(value(0, "upper.reaction_N"), 2.802857142857143, 1e-11);
    EXPECT_NEAR(value(0, "lower.reaction_N"), 0.700714285714286, 1e-11);
    EXPECT_NEAR(value(1, "upper.angle_deg"), 64.3233189141862, 1e-7);
    EXPECT_NEAR(value(1, "lower.angle_deg"), -34.0233947659629, 1e-7);
    EXPECT_NEAR(value(2, "upper.angle_deg"), 159.19704329774, 1e-6);
    EXPECT_NEAR(value(2, "lower.angle_deg"), -22.5358748012673, 1e-6);
    EXPECT_NEAR(value(2, "upper.rate_deg_per_s"), 195.1790774766, 1e-5);
    EXPECT_NEAR(value(2, "lower.rate_deg_per_s"), -165.6118498882, 1e-5);
  }
}

const std::string arms = R"(
name = "arms"; run = { end_time_s = 0.5, output_step_s = 0.25 }
[carrier]; name = "hub"; mass_kg = 50; principal_inertia_kg_m2 = [4, 4, 5]
[[body]]; name = "tip"; mass_kg = 2; com_m = [0.25, 0, 0.01]
principal_inertia_kg_m2 = [0.01, 0.2, 0.2]
hinge = { kind = "axis", axis = [0, 1, 0], on = "arm", parent_point_m = [1, 0, 0] }
start = { angle_deg = 30 }
[[body]]; name = "arm"; mass_kg = 3; com_m = [0.5, 0, 0]
principal_inertia_kg_m2 = [0.02, 0.4, 0.4]
hinge = { kind = "axis", axis = [0, 1, 0], carrier_point_m = [0.5, 0, 0] }
pattern = { count = 3, axis = [0, 0, 1] }
[[force]]; name = "spring"; kind = "motor"; body = "tip"; moment_N_m = 0.3
)"_toml;

// Bodies on a body with copies are copied with it, and all move alike.
TEST(CaseTree, CopiesCarryWhatHangsOnThem) {
  const Case c = parse_case(arms, "c.toml");
  std::vector<std::string> names;
  std::vector<int> on;
  for (const separation::Body& body : c.bodies) {
    names.push_back(body.rigid.name);
    on.push_back(body.hinge.on);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"tip 1", "tip 2", "tip 3", "arm 1",
                                             "arm 2", "arm 3"}));
  EXPECT_EQ(on, (std::vector<int>{4, 5, 6, 0, 0, 0}));
  const Outcome outcome = run_case(c, {});
  ASSERT_EQ(outcome.failure, "");
  const Rows& rows = outcome.memory.rows;
  const auto last = [&](const std::string& column) {
    return rows.at(rows.size() - 1, rows.column(column));
  };
  // Some 40 deg: the sums of three turned copies are rounded differently.
  EXPECT_GT(last("tip_1.angle_deg"), 31);
  for (const char* body : {"tip", "arm"}) {
    const std::string name = body;
    for (const char* other : {"_2", "_3"}) {
      EXPECT_NEAR(last(name + other + ".angle_deg"),
                  last(name + "_1.angle_deg"), 1e-9);
    }
  }
  // A motor acts between the two bodies of its hinge: the hub does not turn.
  EXPECT_NEAR(last("hub.wz_rad_per_s"), 0, 1e-9);
}

// One or several may hang on one of several copies.
TEST(CaseTree, BodiesHangOnOneCopy) {
  const Case c = parse_case(arms + R"(
[[body]]; name = "camera"; mass_kg = 1; principal_inertia_kg_m2 = [0.1, 0.1, 0.1]
hinge = { kind = "ball", on = "arm 2", parent_point_m = [0.5, 0, 0], body_point_m = [0, 0, -0.1] }
)"_toml,
                            "c.toml");
  EXPECT_EQ(c.bodies.back().rigid.name, "camera");
  EXPECT_EQ(c.bodies.back().hinge.on, 5);
  const Case two = parse_case(arms + R"(
[[body]]; name = "wing"; mass_kg = 1; principal_inertia_kg_m2 = [0.1, 0.1, 0.1]
hinge = { kind = "axis", axis = [0, 1, 0], on = "arm 2", parent_point_m = [0.5, 0.1, 0] }
pattern = { count = 2, axis = [1, 0, 0] }
)"_toml,
                              "c.toml");
  EXPECT_EQ(two.bodies[6].hinge.on, 5);
  EXPECT_EQ(two.bodies[7].rigid.name, "wing 2");
  EXPECT_EQ(two.bodies[7].hinge.on, 5);
  // Half a turn about x, from the centre of mass at x = 0.5.
  EXPECT_LE(
      (two.bodies[7].hinge.parent_point - Eigen::Vector3d(0, -0.1, 0)).norm(),
      1e-15);
}

// Drawn numbers of a body affect the bodies that hang on it: its centre of mass
// is the origin of parent_point.
TEST(CaseTree, DrawnNumbersReachWhatHangsOnABody) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / "tree.toml";
  std::ofstream(file) << arms;
  const auto read = [&](const contact::KeySettings& settings) {
    return separation::read_case(file, {}, settings);
  };
  const Case nominal = read({});
  separation::CaseForm form({}, file, {{"body[2].com_m[1]", "0.625"}}, nominal,
                            {});
  const std::vector<double> number = {0.625};
  const Case drawn = form.with({number});
  const Case set = read({{"body[2].com_m[1]", "0.625"}});
  for (std::size_t i = 0; i < nominal.bodies.size(); ++i) {
    EXPECT_EQ(drawn.bodies[i].hinge.parent_point,
              set.bodies[i].hinge.parent_point);
    EXPECT_EQ(drawn.bodies[i].rigid.name, set.bodies[i].rigid.name);
    EXPECT_EQ(drawn.bodies[i].hinge.on, set.bodies[i].hinge.on);
  }
  EXPECT_EQ(drawn.bodies[0].hinge.parent_point[0], 0.375);
  EXPECT_EQ(nominal.bodies[0].hinge.parent_point[0], 0.5);
}

// Two halves on a separated stage: clamps open at one instant, which differs in
// the last bits from the begin of the springs.
TEST(CaseTree, HalvesOpenAlike) {
  const Outcome outcome = run_case(
      separation::read_case(CONTACT_DATA_DIR "/cases/fairing_on_stage.toml"),
      {});
  ASSERT_EQ(outcome.failure, "");
  const auto& bodies = outcome.memory.bodies;
  // An event is where the interpolation of a step has it: 4.6e-8 rad off where
  // the case's tolerance is 1e-8.
  EXPECT_NEAR(bodies[1].release.angle / degree, 60, 1e-7 / degree);
  EXPECT_NEAR(bodies[1].release.time, bodies[2].release.time, 1e-9);
  EXPECT_NEAR(bodies[1].release.rate, bodies[2].release.rate, 1e-9);
}

}  // namespace
}  // namespace contact::test::tree_test
