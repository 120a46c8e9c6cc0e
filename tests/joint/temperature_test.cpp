// Joints at other temperatures than their clearance.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "libcontact/files/joint_file.hpp"
#include "libcontact/joint/joint.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"

namespace contact::test::temperature_test {
namespace {

const Material steel{2.1e11, 0.3, "steel", infinity, 11.5e-6};
const Material bronze{1.1e11, 0.34, "bronze", infinity, 18e-6};

JointSpec bush() {
  return {.geometry = JointGeometry::pin(0.025, 60e-6, 0.05),
          .inner = steel,
          .outer = bronze,
          .friction = FrictionLaw(0.1)};
}

// Both bodies homogeneous: rho (alpha_2 dT_2 - alpha_1 dT_1).
TEST(Temperature, ClearanceGrowsByTheDifference) {
  const JointSpec warm = bush().at({.inner = 373.15, .outer = 333.15});
  const double expected = 60e-6 + 0.025 * (18e-6 * 40 - 11.5e-6 * 80);
  EXPECT_NEAR(warm.geometry.radial_clearance(), expected, 1e-18);
  EXPECT_EQ(warm.thermal_growth->reference_clearance, 60e-6);
  EXPECT_NEAR(warm.thermal_growth->inner, 0.025 * 11.5e-6 * 80, 1e-18);
  // The joint has the grown clearance.
  JointSpec drawn = bush();
  drawn.geometry = drawn.geometry.with_clearance(expected);
  EXPECT_NEAR(warm.contact().half_angle(1e4).half_angle,
              drawn.contact().half_angle(1e4).half_angle, 1e-13);
}

// From the drawing each time: temperatures do not add up.
TEST(Temperature, IsCountedFromTheReference) {
  const JointSpec drawn = bush();
  const JointSpec hot = drawn.at({.inner = 373.15, .outer = 373.15});
  const Temperatures mild = {.inner = 323.15, .outer = 313.15};
  EXPECT_EQ(hot.at(mild), drawn.at(mild));
  const JointSpec back = hot.at({.inner = 293.15, .outer = 293.15});
  EXPECT_EQ(back.geometry, drawn.geometry);
  EXPECT_NE(back, drawn);  // it says more
}

TEST(Temperature, HeldAlongTheAxisAPinWidensMore) {
  Temperatures t{.inner = 343.15, .outer = 293.15};
  const auto clearance = [&] {
    return bush().at(t).geometry.radial_clearance();
  };
  EXPECT_NEAR(clearance(), 60e-6 - 0.025 * 11.5e-6 * 50, 1e-18);
  t.axial = AxialGrowth::held;
  EXPECT_NEAR(clearance(), 60e-6 - 1.3 * 0.025 * 11.5e-6 * 50, 1e-18);
}

const std::string lined =
    "name = \"lined\"\nkind = \"pin\"\n"
    "[geometry]\nradius_mm = 12.5\nradial_clearance_um = 60\nlength_mm = 20\n"
    "[materials.inner]\nyoungs_modulus_GPa = 210\npoissons_ratio = 0.3\n"
    "thermal_expansion_per_K = 1.15e-5\n"
    "[materials.outer]\nyoungs_modulus_GPa = 0.5\npoissons_ratio = 0.4\n"
    "thermal_expansion_per_K = 1.35e-4\n"
    "[friction]\ncoefficient = 0.1\n"
    "[wall]\nbacking = { youngs_modulus_GPa = inf, "
    "thermal_expansion_per_K = 0 }\n[[wall.layer]]\nthickness_mm = 3\n";

// PTFE of 3 mm that is warmed by 30 K in a cold housing takes 26 um of the
// clearance: t/rho = 0.24, -2.40 alpha dT t when it may grow along the axis
// with it, by preload.md's example. Free follows the housing, which is cold.
TEST(Temperature, FilesAndSettingsSayIt) {
  const JointSpec drawn = parse_joint(lined, "lined");
  EXPECT_FALSE(drawn.thermal_growth);
  const auto at = [&](const KeySettings& settings) {
    return parse_joint(lined, "lined", settings);
  };
  const JointSpec warm =
      at({{"inner_temperature_C", "20"}, {"outer_temperature_K", "323.15"}});
  EXPECT_EQ(warm, drawn.at({.inner = 293.15, .outer = 323.15}));
  const double taken =
      drawn.geometry.radial_clearance() - warm.geometry.radial_clearance();
  EXPECT_NEAR(taken / (135e-6 * 30 * 0.003), 2.40, 0.005);
  EXPECT_NEAR(at({{"temperature_C", "20"}}).geometry.radial_clearance(), 60e-6,
              0);
  const JointSpec from_cold =
      at({{"temperature_C", "10"}, {"reference_temperature_C", "-20"}});
  EXPECT_EQ(from_cold, drawn.at({.inner = 10 + 273.15,
                                 .outer = 10 + 273.15,
                                 .reference = -20 + 273.15}));
}

TEST(Temperature, IsPartOfTheText) {
  for (const KeySettings& settings :
       {KeySettings{{"temperature_C", "35"}},
        KeySettings{{"inner_temperature_C", "30"},
                    {"outer_temperature_C", "33.3"},
                    {"reference_temperature_C", "25"},
                    {"axial_growth", "held"}}}) {
    const JointSpec joint = parse_joint(lined, "lined", settings);
    const std::string text = joint.canonical_text();
    const JointSpec again = parse_joint(text, "text");
    EXPECT_EQ(again, joint) << text;
    EXPECT_EQ(again.canonical_text(), text);
    EXPECT_NE(text, parse_joint(lined, "lined").canonical_text());
  }
}

// 0.5 % of free strain: 37 K of PTFE.
TEST(Temperature, NotesWhereItIsNoLongerLinear) {
  const JointSpec drawn = parse_joint(lined, "lined");
  const auto notes = [&](double kelvin) {
    return drawn.at({.inner = 293.15, .outer = kelvin})
        .contact()
        .validity_notes();
  };
  const auto plain = drawn.contact().validity_notes();
  EXPECT_EQ(notes(293.15 + 37), plain);
  const auto hot = notes(293.15 + 38);
  ASSERT_EQ(hot.size(), plain.size() + 1);
  EXPECT_EQ(hot[plain.size()].substr(0, 49),
            "a free thermal strain of 0.00513 exceeds 0.005: e");
}

TEST(Temperature, RefusesWhatCannotBe) {
  EXPECT_ERROR(bush().at({.inner = 20, .outer = 300}),
               "temperatures: inner = 20 must be 100 to 2000 K");
  EXPECT_ERROR(bush().at({.inner = 300, .outer = std::nan("")}),
               "temperatures: outer = nan must be 100 to 2000 K");
}

}  // namespace
}  // namespace contact::test::temperature_test
