// Bearings by designation against the printed tables, and the clearances of
// another maker.
#include "libcontact/pair/spherical_bearing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>
#include <variant>

#include "libcontact/files/joint_file.hpp"
#include "support/error_message.hpp"
#include "support/reference_table.hpp"

namespace contact::test::spherical_bearing_test {
namespace {

using namespace std::string_literals;
using Taken = Fit::Clearance;

TEST(SphericalBearing, IsAsPrinted) {
  const ReferenceTable table("spherical_bearings.csv");
  ASSERT_EQ(table.size(), 57U);
  for (const auto row : table) {
    const SphericalBearing bearing(row.text("designation"));
    EXPECT_EQ(bearing.ball_diameter(), row.value("ball_diameter_mm") / 1e3);
    EXPECT_EQ(bearing.ring_width(), row.value("ring_width_mm") / 1e3);
    EXPECT_EQ(bearing.clearance(Taken::minimum), row.value("least_um") / 1e6)
        << row.text("designation");
    EXPECT_EQ(bearing.clearance(Taken::maximum), row.value("largest_um") / 1e6)
        << row.text("designation");
  }
}

// Another maker has the same groups up to a bore of 200 mm; above it its CN
// begins 10 um lower.
TEST(SphericalBearing, GroupsAreThoseOfAnotherMaker) {
  int compared = 0;
  const ReferenceTable table("spherical_bearing_clearance.csv");
  for (const auto row : table) {
    for (const int bore : {15, 17, 20, 25, 30, 35, 40, 50, 60, 70, 80, 90, 100,
                           120, 140, 160, 180, 200}) {
      if (bore <= row.value("over_mm") || bore > row.value("to_mm")) continue;
      const std::string name = "GE" + std::to_string(bore) + "ES";
      const SphericalBearing c2(name, ClearanceGroup::C2), cn(name),
          c3(name, ClearanceGroup::C3);
      EXPECT_EQ(c2.clearance(Taken::minimum), row.value("c2_least_um") / 1e6);
      EXPECT_EQ(c2.clearance(Taken::maximum), row.value("c2_largest_um") / 1e6)
          << name;
      EXPECT_EQ(cn.clearance(Taken::maximum), row.value("cn_largest_um") / 1e6);
      EXPECT_EQ(c3.clearance(Taken::maximum), row.value("c3_largest_um") / 1e6);
      EXPECT_EQ(cn.clearance(Taken::minimum), c2.clearance(Taken::maximum));
      ++compared;
    }
  }
  EXPECT_EQ(compared, 18);
}

TEST(SphericalBearing, NamesOfMakers) {
  const SphericalBearing e("GE50ES");
  for (const char* name :
       {"GE50", "GE 50 DO", "GE50E", "GE 50 ES-2RS", "ge50es", "GE 50 DO 2RS",
        "GE50DO2RS", "GE50-ES-2RS", "ge50-2RS", "GE50ES CN"}) {
    EXPECT_EQ(SphericalBearing(name).ball_diameter(), e.ball_diameter());
  }
  EXPECT_EQ(SphericalBearing("GEH 50 ES-2LS").ball_diameter(),
            SphericalBearing("GE50FO").ball_diameter());
  for (const char* name :
       {"", "GE", "GE51ES", "GEG50ES", "GE50UK", "6205", "GE-50ES", "GE0ES",
        "GEH6FO", "GE50-UK", "GE50ES-C3", "GE50 C2", "GEH50UK"}) {
    EXPECT_NE(error_message([&] { SphericalBearing{name}; }), "(no error)")
        << name;
  }
}

// Their balls and rings equal the series of their bores (GE50ES, GE30ES,
// GE50FO), their clearances do not.
TEST(SphericalBearing, LinedOnesAreNamedWithTheirSize) {
  for (const char* series :
       {"C", "CJ", "TE", "TXE", "TXA", "TGR", "TXGR", "ET", "UK", "FW"}) {
    EXPECT_TRUE(
        has_text(error_message([&] { SphericalBearing{"GE20"s + series}; }),
                 "series "s + series + " is lined"))
        << series;
  }
  for (const auto& [name, size, series] :
       {std::tuple("GE 50 TXE-2LS", "66, seat.ring_width_mm=28", "TXE"),
        {"GE30UK", "40.7, seat.ring_width_mm=18", "UK"},
        {"ge6c", "10, seat.ring_width_mm=4", "C"},
        {"GE50-FW-2RS", "80, seat.ring_width_mm=36", "FW"}}) {
    EXPECT_EQ(error_message([&] { SphericalBearing{name}; }),
              "bearing "s + name + " requires a joint file, as series " +
                  series +
                  " is lined: data/joints/spherical_plain_bearing_ge50.toml "
                  "with (--set) geometry.diameter_mm=" +
                  size + ", and the maker's clearance, liner and friction");
  }
  EXPECT_EQ(error_message([] { SphericalBearing{"GE50ES C3"}; }),
            "bearing GE50ES C3 requires the clearance group C3 that it names");
  EXPECT_EQ(
      SphericalBearing("GE50ES-C3", ClearanceGroup::C3).radial_clearance(),
      SphericalBearing("GE50ES", ClearanceGroup::C3).radial_clearance());
}

TEST(SphericalBearing, FillsAJointFile) {
  const std::string text = R"(
name = "rod"
kind = "ball"
[geometry]
designation = "GE50ES"
clearance_group = "C3"
clearance = "maximum"
[materials.inner]
youngs_modulus_GPa = 208
poissons_ratio = 0.3
[materials.outer]
youngs_modulus_GPa = 208
poissons_ratio = 0.3
[friction]
preset = "steel_steel_greased"
preset_share = 0
)";
  const JointSpec joint = parse_joint(text, "rod.toml");
  EXPECT_EQ(joint.geometry.radius(), 0.033);
  EXPECT_EQ(joint.geometry.radial_clearance(), 90e-6);
  ASSERT_TRUE(joint.geometry.seat());
  EXPECT_NEAR(joint.geometry.seat()->to() - joint.geometry.seat()->from(),
              2 * std::asin(28.0 / 66), 1e-14);
  EXPECT_EQ(std::get<FrictionLaw>(*joint.friction).coefficient(), 0.08);
  // The text of the joint is the joint.
  EXPECT_EQ(parse_joint(joint.canonical_text(), ""), joint);
  // Without its ring it is no bearing.
  const JointSpec endless =
      parse_joint(joint.without_seat().canonical_text(), "");
  EXPECT_FALSE(endless.geometry.seat());
  EXPECT_EQ(endless.geometry, joint.geometry.without_seat());
  EXPECT_EQ(joint.clearance_notes().at(0),
            "bearing GE50ES C3: ball of 66 mm, ring of 28 mm, diametral "
            "clearance 120 to 180 um; maximum 180 um taken");
}

}  // namespace
}  // namespace contact::test::spherical_bearing_test
