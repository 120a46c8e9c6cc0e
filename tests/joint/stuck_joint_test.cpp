// Stiffness, friction and shape of joints that friction holds, against
// data/reference/presliding.
#include "libcontact/joint/presliding/stuck_joint.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "libcontact/base/units.hpp"
#include "libcontact/files/joint_file.hpp"
#include "support/accuracy_report.hpp"
#include "support/reference_table.hpp"

namespace contact::test::stuck_joint_test {
namespace {

JointSpec spec_of(const std::string& name, double coefficient) {
  JointSpec spec =
      read_joint(CONTACT_DATA_DIR "/joints/" + name + ".toml").without_seat();
  spec.friction = FrictionLaw(coefficient);
  spec.half_angle_law = "exact";
  spec.pressure_law = "exact";
  return spec;
}

StuckJoint stuck_under(const JointSpec& spec, double force) {
  const JointContact contact = spec.contact();
  return stuck_joint(spec, contact, force,
                     contact.half_angle(force).half_angle);
}

TEST(StuckJoint, JointsAreThoseOfTheReference) {
  AccuracyReport load("K_load", 5e-4);
  AccuracyReport held("K_held", 5e-4);
  AccuracyReport spin("K_spin", 5e-4);
  AccuracyReport moment("M_s", 5e-4);
  for (const auto& row : ReferenceTable("presliding/joints.csv")) {
    const JointSpec spec = spec_of(row.text("joint"), row.value("f"));
    const StuckJoint stuck = stuck_under(spec, row.value("R_N"));
    load.add(stuck.load_stiffness, row.value("K_fixed_load_Nm_per_rad"),
             row.label());
    // The file has the reaction R: R_n = R/sqrt(1 + f^2); the change of theta0
    // is 3e-4.
    moment.add(stuck.friction_moment / std::hypot(1, row.value("f")),
               row.value("M_slide_Nm"), row.label());
    if (spec.geometry.kind() == JointKind::pin) {
      EXPECT_TRUE(std::isnan(stuck.held_stiffness));  // its hole is infinite
      EXPECT_TRUE(std::isnan(stuck.spin_stiffness));
      continue;
    }
    held.add(stuck.held_stiffness, row.value("K_centre_held_Nm_per_rad"),
             row.label());
    spin.add(stuck.spin_stiffness, row.value("K_spin_Nm_per_rad"), row.label());
  }
}

LayeredBody body(double modulus, double nu) {
  return {{}, Backing::medium({modulus, nu})};
}

TEST(StuckJoint, ShapeIsThatOfPinsThatSlipBitByBit) {
  int compared = 0;
  for (const auto& row : ReferenceTable("presliding/partial_slip.csv")) {
    // Contacts narrower than the friction angle roll.
    const double angle = row.value("theta0_deg") * degree;
    const double f = row.value("friction");
    if (row.value("centre_held") != 0 || angle < std::atan(f)) continue;
    const std::string& pair = row.text("case");
    const LayeredBody rigid{{}, Backing::rigid()};
    JointSpec spec{.geometry = JointGeometry::pin(1, 1e-3, 1),
                   .inner = pair == "similar" ? body(1e9, 0.3) : rigid,
                   .outer = body(1e9, 0.3),
                   .friction = FrictionLaw(f)};
    if (pair == "bush") {
      spec.inner = body(2e9, 0.3);
      spec.outer = {{{0.2, {1e9, 0.34}}}, Backing::medium({2e9, 0.3})};
    } else if (pair == "liner.05") {
      spec.outer = {{{0.05, {1e9, 0.4}}}, Backing::rigid()};
    }
    const StuckJoint stuck = stuck_joint(spec, spec.contact(), 1e3, angle);
    EXPECT_NEAR(stuck.shape, row.value("shape_b"), 0.2) << row.label();
    ++compared;
  }
  EXPECT_EQ(compared, 11);
}

TEST(StuckJoint, NumbersOfModelsFollowFromTheShape) {
  for (const double b : {1.0, 1.2, 1.5, 1e6}) {
    const StuckJoint stuck{1000, 3000, 1500, 2, b};
    EXPECT_DOUBLE_EQ(stuck.dahl_exponent(), (b - 1) / b);
    EXPECT_DOUBLE_EQ(stuck.breakaway_angle(), b * 2 / 1000);
    // Both curves are at M_s/2 there.
    const double x = std::log(2.0) * 1000 / stuck.lugre_stiffness();
    EXPECT_NEAR(std::pow(1 - x / b, b), 0.5, 1e-9);
  }
}

TEST(StuckJoint, IsNanWhereItIsNotKnown) {
  const JointSpec hip = spec_of("hip_cocr_uhmwpe", 0.1);
  const JointContact contact = hip.contact();
  EXPECT_FALSE(std::isnan(stuck_joint(hip, contact, 1, 0.5).load_stiffness));
  for (const double force : {0.0, -1.0, std::nan("")}) {
    EXPECT_TRUE(
        std::isnan(stuck_joint(hip, contact, force, 0.5).load_stiffness));
  }
  EXPECT_TRUE(std::isnan(stuck_joint(hip, contact, 1, 0.001).load_stiffness));
  const JointSpec pressed = spec_of("lined_bush_pressed", 0.1);
  EXPECT_TRUE(std::isnan(stuck_under(pressed, 2000).load_stiffness));
  // And says why.
  const auto why = [](const JointSpec& spec, double angle) {
    const auto notes = stuck_notes(spec, angle);
    return notes.size() == 1 ? notes[0].substr(41) : "";
  };
  EXPECT_EQ(why(pressed, 1), "because the joint has interference");
  EXPECT_EQ(why(hip, 0.0099),
            "because the half-angle is 0.567 deg: only 0.57 to 177.6 deg are "
            "computed");
  EXPECT_EQ(why(hip, 0.0101), "");
  JointSpec film = hip;
  film.outer = {{{0.9e-3 * hip.geometry.radius(), {1e9, 0.4}}},
                Backing::rigid()};
  EXPECT_EQ(why(film, 1),
            "because a layer is 0.0009 radii thick: layers below 0.001 cannot "
            "be computed");
  EXPECT_TRUE(std::isnan(stuck_under(film, 2000).load_stiffness));
  const JointContact viscous = contact.with_friction(ViscousLaw(1, 1));
  const StuckJoint stuck = stuck_joint(hip, viscous, 1, 0.5);
  EXPECT_GT(stuck.load_stiffness, 0);
  EXPECT_TRUE(std::isnan(stuck.friction_moment));
}

TEST(StuckJoint, WideHomogeneousContactsAreNoted) {
  const JointSpec steel = spec_of("paper_example_1", 0.1);
  EXPECT_EQ(stuck_notes(steel, 43.1 * degree).size(), 1U);
  EXPECT_TRUE(stuck_notes(steel, 42.9 * degree).empty());
  EXPECT_TRUE(stuck_notes(steel, std::nan("")).empty());
  // The stiffness ignores a rim at 90 deg.
  EXPECT_TRUE(stuck_notes(spec_of("hip_cup", 0.1), 89 * degree).empty());
  EXPECT_EQ(stuck_notes(spec_of("hip_cup", 0.1), 91 * degree).size(), 1U);
  EXPECT_TRUE(
      stuck_notes(spec_of("hip_cocr_uhmwpe", 0.1), 80 * degree).empty());
}

}  // namespace
}  // namespace contact::test::stuck_joint_test
