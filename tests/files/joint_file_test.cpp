#include "libcontact/files/joint_file.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/conforming/ball.hpp"
#include "libcontact/half_angle/exact.hpp"
#include "libcontact/pressure/exact.hpp"
#include "support/error_message.hpp"

namespace {

namespace fs = std::filesystem;
using contact::degree;
using contact::Dimension;
using contact::FrictionLaw;
using contact::FrictionModel;
using contact::Interval;
using contact::JointBody;
using contact::JointKind;
using contact::JointSpec;
using contact::LayeredPair;
using contact::parse_joint;
using contact::parse_material_pair;
using contact::TomlTable;
using contact::ViscousLaw;
using contact::test::error_message;

constexpr double infinity = std::numeric_limits<double>::infinity();

// A joint file line by line, so that a test can exchange one.
const std::vector<std::string> good_lines = {
    "name = \"test joint\"",         // 1
    "kind = \"ball\"",               // 2
    "[geometry]",                    // 3
    "radius_mm = 50",                // 4
    "radial_clearance_um = 50",      // 5
    "[materials.inner]",             // 6
    "name = \"steel\"",              // 7
    "youngs_modulus_GPa = 200",      // 8
    "poissons_ratio = 0.3",          // 9
    "[materials.outer]",             // 10
    "youngs_modulus = 1.1e11",       // 11
    "poissons_ratio = 0.34",         // 12
    "[friction]",                    // 13
    "coefficient = 0.1",             // 14
    "adhesion_MPa = 40",             // 15
    "[half_angle]",                  // 16
    "law = \"tanh\"",                // 17
    "limit_half_angle_deg = 84.85",  // 18
    "[pressure]",                    // 19
    "law = \"cosine\"",              // 20
};

std::string text_of(std::vector<std::string> lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

// The good file with line `number` (from 1) exchanged.
std::string with_line(int number, const std::string& line) {
  std::vector<std::string> lines = good_lines;
  lines[number - 1] = line;
  return text_of(lines);
}

const FrictionLaw& dry(const std::optional<FrictionModel>& friction) {
  return std::get<FrictionLaw>(friction.value());
}

const ViscousLaw& viscous(const std::optional<FrictionModel>& friction) {
  return std::get<ViscousLaw>(friction.value());
}

// What reading the good file with one line exchanged says.
std::string message_with_line(int number, const std::string& line) {
  return error_message([&] { parse_joint(with_line(number, line), "j.toml"); });
}

TEST(JointFile, ReadsEverything) {
  const JointSpec joint = parse_joint(text_of(good_lines), "j.toml");
  EXPECT_EQ(joint.name, "test joint");
  EXPECT_EQ(joint.geometry.kind(), JointKind::ball);
  EXPECT_EQ(joint.geometry.inner_body(), JointBody::carrier);
  // Units by exact powers of ten: the doubles nearest to the decimals.
  EXPECT_EQ(joint.geometry.radius(), 0.05);
  EXPECT_EQ(joint.geometry.radial_clearance(), 50e-6);
  EXPECT_EQ(joint.pair.inner().name, "steel");
  EXPECT_EQ(joint.pair.inner().youngs_modulus, 2e11);
  EXPECT_EQ(joint.pair.outer().youngs_modulus, 1.1e11);
  EXPECT_EQ(joint.pair.outer().poissons_ratio, 0.34);
  EXPECT_EQ(dry(joint.friction).coefficient(), 0.1);
  EXPECT_EQ(dry(joint.friction).adhesion(), 4e7);
  EXPECT_EQ(joint.half_angle_law, "tanh");
  EXPECT_EQ(joint.make_half_angle_law()->name(), "tanh");
  EXPECT_EQ(joint.make_half_angle_law()->limit_half_angle(), 84.85 * degree);
  EXPECT_EQ(joint.make_pressure_law()->name(), "cosine");
  EXPECT_TRUE(joint.validity_notes().empty());
}

TEST(JointFile, DefaultsAndOtherSpellings) {
  const JointSpec joint = parse_joint(R"(
      name = "pin"
      kind = "pin"
      inner_body = "body"
      [geometry]
      radius = 0.01
      relative_clearance = 0.002
      length_m = 0.03
      [materials.inner]
      youngs_modulus_MPa = 210_000
      poissons_ratio = 0.3
      [materials.outer]
      youngs_modulus = inf
      [half_angle]
      law = "paper"
      limit_formula = "arctan"
      degrees_per_radian = 57.3
      )",
                                      "pin.toml");
  EXPECT_EQ(joint.geometry.kind(), JointKind::pin);
  EXPECT_EQ(joint.geometry.inner_body(), JointBody::body);
  EXPECT_EQ(joint.geometry.radial_clearance(), 0.002 * 0.01);
  EXPECT_EQ(joint.geometry.length(), 0.03);
  EXPECT_EQ(joint.pair.inner().youngs_modulus, 2.1e11);
  EXPECT_EQ(joint.pair.modulus_ratio(), 0);
  EXPECT_FALSE(joint.friction.has_value());
  EXPECT_EQ(joint.half_angle_law, "paper");
  EXPECT_EQ(joint.pressure_law, contact::default_pressure_law);
  EXPECT_EQ(joint.half_angle_options.initial_slope, 57.3 * degree);
  EXPECT_EQ(joint.validity_notes().size(), 1u);  // a blend, modulus ratio 0
}

TEST(JointFile, LawThatHoldsForEveryPairUnlessNamed) {
  const JointSpec joint = parse_joint(R"(
      name = "ball"
      kind = "ball"
      geometry = { radius_mm = 10, relative_clearance = 0.002 }
      materials.inner = { youngs_modulus_GPa = 210, poissons_ratio = 0.3 }
      materials.outer = { youngs_modulus_GPa = 3, poissons_ratio = 0.45 }
      )",
                                      "ball.toml");
  EXPECT_EQ(joint.half_angle_law, contact::default_half_angle_law);
  EXPECT_EQ(joint.make_half_angle_law()->name(), "fitted");
  EXPECT_TRUE(joint.validity_notes().empty());
}

TEST(JointFile, ViscousFriction) {
  const auto friction = [](const std::string& first,
                           const std::string& second) {
    std::vector<std::string> lines = good_lines;
    lines[13] = first;
    lines[14] = second;
    return parse_joint(text_of(lines), "j.toml").friction;
  };
  const auto both = friction("viscous_constant_kPa_s_per_m = 2.5",
                             "viscous_pressure_slope_s_per_m = 1e-4");
  EXPECT_EQ(viscous(both).constant(), 2500);
  EXPECT_EQ(viscous(both).pressure_slope(), 1e-4);
  const auto constant = friction("viscous_constant = 3", "");
  EXPECT_EQ(viscous(constant).constant(), 3);
  EXPECT_EQ(viscous(constant).pressure_slope(), 0);
  const auto slope = friction("viscous_pressure_slope = 4", "");
  EXPECT_EQ(viscous(slope).constant(), 0);
  EXPECT_EQ(viscous(slope).pressure_slope(), 4);

  EXPECT_EQ(message_with_line(14, "viscous_constant = -1"),
            "j.toml:14: friction.viscous_constant = -1: allowed: 0 Pa s/m or "
            "above");
  EXPECT_EQ(message_with_line(14, "viscous_pressure_slope_s_per_m = nan"),
            "j.toml:14: friction.viscous_pressure_slope_s_per_m = nan: "
            "allowed: 0 s/m or above");
  EXPECT_EQ(message_with_line(14, "viscous_constant = 1"),
            "j.toml:14: friction.viscous_constant = 1: allowed: not together "
            "with coefficient or adhesion");
  EXPECT_EQ(message_with_line(15, "viscous_pressure_slope = 1"),
            "j.toml:15: friction.viscous_pressure_slope = 1: allowed: not "
            "together with coefficient or adhesion");
  EXPECT_EQ(message_with_line(14, "viscous_constant_Pa = 1"),
            "j.toml:14: friction.viscous_constant_Pa: unknown key: did you "
            "mean viscous_constant?");
}

TEST(JointFile, NamesFileLineKeyValueAndRange) {
  EXPECT_EQ(message_with_line(1, ""), "j.toml:1: name is missing");
  EXPECT_EQ(message_with_line(1, "name = \"\""),
            "j.toml:1: name = \"\": allowed: a string, not empty");
  EXPECT_EQ(message_with_line(1, "name = 3"),
            "j.toml:1: name = 3: allowed: a string, not empty");
  EXPECT_EQ(message_with_line(2, "kind = \"spherical\""),
            "j.toml:2: kind = \"spherical\": allowed: \"ball\", "
            "\"pin\"");
  EXPECT_EQ(message_with_line(2, "kind = true"),
            "j.toml:2: kind = true: allowed: \"ball\", \"pin\"");
  EXPECT_EQ(message_with_line(4, "radius_mm = -50"),
            "j.toml:4: geometry.radius_mm = -50: allowed: above 0 mm");
  EXPECT_EQ(message_with_line(4, "radius_mm = 0.0"),
            "j.toml:4: geometry.radius_mm = 0: allowed: above 0 mm");
  EXPECT_EQ(message_with_line(4, "radius_mm = nan"),
            "j.toml:4: geometry.radius_mm = nan: allowed: above 0 mm");
  EXPECT_EQ(message_with_line(4, "radius_mm = inf"),
            "j.toml:4: geometry.radius_mm = inf: allowed: above 0 mm, finite");
  EXPECT_EQ(message_with_line(4, "radius_mm = \"50\""),
            "j.toml:4: geometry.radius_mm = \"50\": allowed: a number");
  EXPECT_EQ(message_with_line(4, "radius_mm = [50]"),
            "j.toml:4: geometry.radius_mm = [50]: allowed: a number");
  EXPECT_EQ(message_with_line(4, "radius_mm = 2024-05-01"),
            "j.toml:4: geometry.radius_mm = 2024-05-01: allowed: a number");
  EXPECT_EQ(message_with_line(5, "radial_clearance_mm = 50"),
            "j.toml:5: geometry.radial_clearance_mm = 50: allowed: above 0, "
            "below 50 mm");
  EXPECT_EQ(message_with_line(5, "relative_clearance = 1"),
            "j.toml:5: geometry.relative_clearance = 1: allowed: above 0, "
            "below 1");
  EXPECT_EQ(message_with_line(8, "youngs_modulus = 200"),
            "j.toml:8: materials.inner.youngs_modulus = 200: allowed: 1000 to "
            "1e+13 Pa, or inf");
  EXPECT_EQ(message_with_line(8, "youngs_modulus_GPa = 2e11"),
            "j.toml:8: materials.inner.youngs_modulus_GPa = 200000000000: "
            "allowed: 1e-06 to 10000 GPa, or inf");
  EXPECT_EQ(message_with_line(8, "youngs_modulus_GPa = -inf"),
            "j.toml:8: materials.inner.youngs_modulus_GPa = -inf: allowed: "
            "1e-06 to 10000 GPa, or inf");
  EXPECT_EQ(message_with_line(12, "poissons_ratio = 0.6"),
            "j.toml:12: materials.outer.poissons_ratio = 0.6: allowed: 0 to "
            "0.5");
  EXPECT_EQ(message_with_line(14, "coefficient = -0.1"),
            "j.toml:14: friction.coefficient = -0.1: allowed: 0 or above");
  EXPECT_EQ(message_with_line(15, "adhesion_kPa = -1"),
            "j.toml:15: friction.adhesion_kPa = -1: allowed: 0 kPa or above");
  EXPECT_EQ(message_with_line(18, "limit_half_angle_deg = 180"),
            "j.toml:18: half_angle.limit_half_angle_deg = 180: allowed: above "
            "0, below 180 deg");
  EXPECT_EQ(message_with_line(18, "degrees_per_radian = 59"),
            "j.toml:18: half_angle.degrees_per_radian = 59: allowed: 57 to "
            "58");
}

TEST(JointFile, MissingKeysAndTables) {
  EXPECT_EQ(message_with_line(4, ""),
            "j.toml:3: geometry.radius is missing: allowed: radius (in m), "
            "radius_m, radius_mm, radius_um, radius_km");
  EXPECT_EQ(message_with_line(4, "raduis_mm = 50"),
            "j.toml:4: geometry.raduis_mm: unknown key: did you mean "
            "radius_mm?");
  EXPECT_EQ(message_with_line(9, ""),
            "j.toml:6: materials.inner.poissons_ratio is missing");
  EXPECT_EQ(message_with_line(14, ""),
            "j.toml:13: friction.coefficient is missing");
  EXPECT_EQ(message_with_line(3, "[geometrie]"),
            "j.toml:3: geometrie: unknown key: did you mean geometry?");
  const std::string begin = "name = \"j\"\nkind = \"ball\"\n";
  EXPECT_EQ(error_message([&] { parse_joint(begin, "j.toml"); }),
            "j.toml:1: the table [geometry] is missing");
  EXPECT_EQ(error_message([&] {
              parse_joint(
                  begin +
                      "geometry = { radius = 1, radial_clearance = 0.1 }"
                      "\n[materials.inner]\nyoungs_modulus = 1e9\n"
                      "poissons_ratio = 0.3\n",
                  "j.toml");
            }),
            "j.toml:4: the table [materials.outer] is missing");
  // What is there instead comes first.
  EXPECT_EQ(
      message_with_line(3, "[shape]"),
      "j.toml:3: shape: unknown key: allowed: coating, friction, geometry, "
      "half_angle, inner_body, kind, loading, materials, name, pressure, "
      "wall");
  EXPECT_EQ(message_with_line(10, "[materials.seat]"),
            "j.toml:10: materials.seat: unknown key: allowed: inner, outer, "
            "pair");
  EXPECT_EQ(message_with_line(2, "kind = \"pin\""),
            "j.toml:3: geometry.length is missing: allowed: length (in m), "
            "length_m, length_mm, length_um, length_km");
  EXPECT_EQ(error_message([] { parse_joint("", "j.toml"); }),
            "j.toml:1: name is missing");
}

TEST(JointFile, UnknownKeysAreRefusedWithTheNearest) {
  EXPECT_EQ(message_with_line(15, "adhesion_Mpa = 40"),
            "j.toml:15: friction.adhesion_Mpa: unknown key: did you mean "
            "adhesion_MPa?");
  EXPECT_EQ(message_with_line(15, "adehsion = 40"),
            "j.toml:15: friction.adehsion: unknown key: did you mean "
            "adhesion?");
  EXPECT_EQ(message_with_line(15, "temperature = 300"),
            "j.toml:15: friction.temperature: unknown key: allowed: adhesion, "
            "coefficient, viscous_constant, viscous_pressure_slope");
  EXPECT_EQ(message_with_line(13, "[frictoin]"),
            "j.toml:13: frictoin: unknown key: did you mean friction?");
  EXPECT_EQ(message_with_line(3, "[geometry]\nlength_mm = 3"),
            "j.toml:4: geometry.length_mm: unknown key: allowed: "
            "radial_clearance, radius, relative_clearance");
  EXPECT_EQ(message_with_line(16, "[half_angle]\n\"odd \\n key\" = 1"),
            "j.toml:17: half_angle.\"odd \\x0a key\": unknown key: allowed: "
            "degrees_per_radian, law, limit_formula, limit_half_angle");
  // The first line of several.
  EXPECT_EQ(
      message_with_line(5, "radial_clearance_um = 50\nzeta = 1\nbeta = 2"),
      "j.toml:6: geometry.zeta: unknown key: allowed: length, "
      "radial_clearance, radius, relative_clearance");
}

TEST(JointFile, OneKeyInTwoUnits) {
  EXPECT_EQ(message_with_line(5, "radial_clearance_um = 50\nradius = 0.05"),
            "j.toml:4: geometry.radius_mm: allowed: not together with radius "
            "in line 6");
  EXPECT_EQ(
      message_with_line(5,
                        "radial_clearance_um = 50\n"
                        "relative_clearance = 0.001"),
      "j.toml:6: geometry.relative_clearance = 0.001: allowed: not together "
      "with radial_clearance");
}

TEST(JointFile, LawsAreChecked) {
  EXPECT_EQ(message_with_line(17, "law = \"tan\""),
            "j.toml:17: half_angle.law = \"tan\": half-angle law tan: allowed: "
            "hertz, arctan, tanh, blend, paper, fitted, exact");
  EXPECT_EQ(message_with_line(17, "law = \"blend:2\""),
            "j.toml:17: half_angle.law = \"blend:2\": blend law: k = 2: "
            "allowed: 0 to 1");
  EXPECT_EQ(message_with_line(20, "law = \"flat\""),
            "j.toml:20: pressure.law = \"flat\": pressure law flat: allowed: "
            "cosine, sqrt_tan, sqrt_theta, mixture, exact");
  EXPECT_EQ(message_with_line(18, "limit_formula = \"cubic\""),
            "j.toml:18: half_angle.limit_formula = \"cubic\": allowed: "
            "\"arctan\", \"linear\"");
  // Half-angle options belong to the paper's laws.
  const std::string only =
      ": allowed: with the laws arctan, tanh, blend and paper; this joint has ";
  EXPECT_EQ(
      message_with_line(17, "law = \"exact\""),
      "j.toml:18: half_angle.limit_half_angle_deg = 84.85" + only + "exact");
  EXPECT_EQ(message_with_line(17, "limit_formula = \"arctan\""),
            "j.toml:18: half_angle.limit_half_angle_deg = 84.85" + only +
                std::string(contact::default_half_angle_law));
  std::string text = with_line(18, "limit_formula = \"linear\"");
  EXPECT_EQ(error_message([&] { parse_joint(text, "j.toml"); }), "(no error)");
  text.replace(text.find("1.1e11"), 6, "2.0e10");
  EXPECT_EQ(error_message([&] { parse_joint(text, "j.toml"); }),
            "j.toml:17: half_angle.law = \"tanh\": linear limit half-angle: "
            "modulus_ratio = 10: allowed: 0.5 to 2");
}

TEST(JointFile, Loading) {
  const auto file = [](const std::string& law, const std::string& pressure,
                       const std::string& loading) {
    std::vector<std::string> lines = good_lines;
    lines[16] = law;
    lines[17] = "";
    lines[19] = pressure;
    lines.push_back(loading);
    return text_of(lines);
  };
  const auto message = [&](const std::string& law, const std::string& pressure,
                           const std::string& loading) {
    return error_message(
        [&] { parse_joint(file(law, pressure, loading), "j.toml"); });
  };
  const std::string exact = "law = \"exact\"";
  const std::string back = "[loading]\nkind = \"back\"\n";
  const std::string patch = back + "patch_half_angle_deg = 20";

  const JointSpec joint = parse_joint(file(exact, exact, patch), "j.toml");
  const auto loading = contact::InnerLoading::back(20 * degree);
  EXPECT_EQ(joint.conditions.loading, loading);
  const contact::ExactLaw law(JointKind::ball, joint.pair, loading);
  EXPECT_EQ(joint.make_half_angle_law()->half_angle(3).half_angle,
            law.half_angle(3).half_angle);
  const contact::ExactPressure pressure(JointKind::ball, joint.pair, loading);
  EXPECT_EQ(joint.make_pressure_law()->peak(1), pressure.peak(1));
  const auto centre = contact::InnerLoading::centre();
  EXPECT_EQ(parse_joint(text_of(good_lines), "j.toml").conditions.loading,
            centre);
  EXPECT_EQ(
      parse_joint(file(exact, exact, "[loading]\nkind = \"centre\""), "j.toml")
          .conditions.loading,
      centre);

  const std::string place =
      "j.toml:22: loading.kind = \"back\": allowed: with ";
  EXPECT_EQ(message("", exact, patch),
            place + "the half-angle law exact; this joint has fitted");
  EXPECT_EQ(message("law = \"tanh\"", exact, patch),
            place + "the half-angle law exact; this joint has tanh");
  EXPECT_EQ(message(exact, "law = \"mixture\"", patch),
            place +
                "the pressure laws cosine, sqrt_tan, sqrt_theta and "
                "exact; this joint has mixture");
  EXPECT_EQ(message(exact, "law = \"cosine\"", patch), "(no error)");
  EXPECT_EQ(message(exact, exact, "[loading]\nkind = \"side\""),
            "j.toml:22: loading.kind = \"side\": allowed: \"centre\", "
            "\"back\"");
  EXPECT_EQ(message(exact, exact, back + "patch_half_angle_deg = 91"),
            "j.toml:23: loading.patch_half_angle_deg = 91: allowed: 0 to 90 "
            "deg");
  EXPECT_EQ(message(exact, exact, back),
            "j.toml:21: loading.patch_half_angle is missing: allowed: "
            "patch_half_angle (in rad), patch_half_angle_rad, "
            "patch_half_angle_deg");
  EXPECT_EQ(message(exact, exact,
                    "[loading]\nkind = \"centre\"\npatch_half_angle = 1"),
            "j.toml:23: loading.patch_half_angle = 1: allowed: with kind = "
            "\"back\"");
}

// The good file with walls in place of its laws.
std::string with_walls(const std::string& walls) {
  std::vector<std::string> lines(good_lines.begin(), good_lines.begin() + 15);
  lines.push_back(walls);  // 16
  return text_of(lines);
}

std::string message_with_walls(const std::string& walls) {
  return error_message([&] { parse_joint(with_walls(walls), "j.toml"); });
}

TEST(JointFile, Walls) {
  const JointSpec joint = parse_joint(
      with_walls(
          "[wall]\n"
          "backing = { youngs_modulus_GPa = 120, poissons_ratio = 0.25 }\n"
          "[[wall.layer]]\nthickness_mm = 3\n"
          "[[wall.layer]]\nthickness_um = 40\n"
          "youngs_modulus_GPa = 2\npoissons_ratio = 0.4\n"
          "[[coating]]\nthickness_um = 500\n"
          "youngs_modulus_GPa = 300\npoissons_ratio = 0.2\n"),
      "j.toml");
  ASSERT_TRUE(joint.conditions.walls.has_value());
  const LayeredPair& walls = *joint.conditions.walls;
  EXPECT_EQ(walls.radius(), 0.05);
  ASSERT_EQ(walls.outer().layers.size(), 2u);
  EXPECT_EQ(walls.outer().layers[0].thickness, 3e-3);
  EXPECT_EQ(walls.outer().layers[0].material.youngs_modulus, 1.1e11);
  EXPECT_EQ(walls.outer().layers[1].thickness, 40e-6);
  EXPECT_EQ(walls.outer().layers[1].material.poissons_ratio, 0.4);
  EXPECT_EQ(walls.outer().backing.material().youngs_modulus, 1.2e11);
  ASSERT_EQ(walls.inner().layers.size(), 1u);
  EXPECT_EQ(walls.inner().layers[0].material.youngs_modulus, 3e11);
  EXPECT_EQ(walls.inner().backing.material().name, "steel");
  // The pair is that of the surfaces, and the laws are those that know walls.
  EXPECT_EQ(joint.pair.inner().youngs_modulus, 3e11);
  EXPECT_EQ(joint.pair.outer().youngs_modulus, 1.1e11);
  EXPECT_EQ(joint.half_angle_law, "exact");
  EXPECT_EQ(joint.pressure_law, "exact");
  const contact::ExactLaw law(JointKind::ball, walls);
  EXPECT_EQ(joint.make_half_angle_law()->half_angle(3).half_angle,
            law.half_angle(3).half_angle);
  EXPECT_NE(
      law.half_angle(3).half_angle,
      contact::ExactLaw(JointKind::ball, joint.pair).half_angle(3).half_angle);
  const contact::ExactPressure pressure(JointKind::ball, walls);
  EXPECT_EQ(joint.make_pressure_law()->peak(1), pressure.peak(1));

  // A first layer with a material of its own; loading through the back.
  const JointSpec own = parse_joint(
      with_walls("[wall]\nbacking = \"held\"\n[[wall.layer]]\n"
                 "thickness_mm = 30\nyoungs_modulus_GPa = 3\n"
                 "poissons_ratio = 0.5\n"
                 "[loading]\nkind = \"back\"\npatch_half_angle_deg = 10"),
      "j.toml");
  EXPECT_EQ(own.pair.outer().youngs_modulus, 3e9);
  EXPECT_EQ(own.conditions.walls->outer().backing.kind(),
            contact::Backing::Kind::held);
  EXPECT_TRUE(own.conditions.loading.is_back());
  EXPECT_TRUE(own.conditions.walls->inner().layers.empty());

  // A coating alone.
  const JointSpec coated =
      parse_joint(with_walls("[[coating]]\nthickness_mm = 1\n"
                             "youngs_modulus_GPa = 3\npoissons_ratio = 0.3"),
                  "j.toml");
  EXPECT_TRUE(coated.conditions.walls->outer().layers.empty());
  EXPECT_EQ(coated.half_angle_law, "exact");
}

TEST(JointFile, WallsAreChecked) {
  const std::string wall = "[wall]\nbacking = \"rigid\"\n";        // 16, 17
  const std::string layer = "[[wall.layer]]\nthickness_mm = 8\n";  // 18, 19
  const std::string material = "youngs_modulus_GPa = 3\npoissons_ratio = 0.3\n";
  EXPECT_EQ(message_with_walls(wall + layer), "(no error)");
  const auto thickness = [&](const std::string& value) {
    return message_with_walls(wall + "[[wall.layer]]\nthickness_mm = " + value);
  };
  const std::string place = "j.toml:19: wall.layer[1].thickness_mm = ";
  EXPECT_EQ(thickness("-3"), place + "-3: allowed: above 0 mm");
  EXPECT_EQ(thickness("0"), place + "0: allowed: above 0 mm");
  EXPECT_EQ(thickness("0.0004"),
            place + "0.0004: allowed: 1e-05 to 1e+06 of the radius of 0.05 m");
  EXPECT_EQ(
      thickness("6e7"),
      place + "60000000: allowed: 1e-05 to 1e+06 of the radius of 0.05 m");
  EXPECT_EQ(message_with_walls(wall + layer + layer),
            "j.toml:20: wall.layer[2].youngs_modulus is missing: allowed: "
            "youngs_modulus (in Pa), youngs_modulus_Pa, youngs_modulus_kPa, "
            "youngs_modulus_MPa, youngs_modulus_GPa");
  EXPECT_EQ(message_with_walls(wall + layer + "poissons_ratio = 0.4"),
            "j.toml:18: wall.layer[1].youngs_modulus is missing: allowed: "
            "youngs_modulus (in Pa), youngs_modulus_Pa, youngs_modulus_kPa, "
            "youngs_modulus_MPa, youngs_modulus_GPa");
  EXPECT_EQ(message_with_walls(wall + layer + "youngs_modulus = inf"),
            "j.toml:20: wall.layer[1].youngs_modulus = inf: allowed: 1000 to "
            "1e+13 Pa");
  std::string rigid = with_walls(wall + layer);
  rigid.replace(rigid.find("1.1e11"), 6, "inf");
  EXPECT_EQ(error_message([&] { parse_joint(rigid, "j.toml"); }),
            "j.toml:18: wall.layer[1].youngs_modulus is missing: the outer "
            "body of the materials is rigid, a layer is elastic");

  const std::string backings =
      "\"rigid\", \"held\", a material { youngs_modulus, poissons_ratio }";
  EXPECT_EQ(message_with_walls(layer),
            "j.toml:16: wall.backing is missing: allowed: " + backings +
                ", behind the layers");
  EXPECT_EQ(message_with_walls("[wall]\nbacking = \"soft\"\n" + layer),
            "j.toml:17: wall.backing = \"soft\": allowed: " + backings);
  EXPECT_EQ(message_with_walls("[wall]\nbacking = 3\n" + layer),
            "j.toml:17: wall.backing = 3: allowed: " + backings);
  EXPECT_EQ(message_with_walls("[wall]\nbacking = { youngs_modulus = 1e9 }\n" +
                               layer),
            "j.toml:17: wall.backing.poissons_ratio is missing");
  EXPECT_EQ(message_with_walls(wall),
            "j.toml:16: wall.layer is missing: a wall has at least one "
            "[[wall.layer]]; an outer body that is rigid as a whole has "
            "youngs_modulus = inf");
  EXPECT_EQ(message_with_walls(wall + "thickness = 1\n" + layer),
            "j.toml:18: wall.thickness: unknown key: allowed: backing, layer");

  const auto coating = [&](const std::string& value) {
    return "[[coating]]\nthickness_mm = " + value + '\n' + material;
  };
  EXPECT_EQ(message_with_walls(coating("50")),
            "j.toml:17: coating[1].thickness_mm = 50: allowed: all coatings "
            "together below the radius of 0.05 m");
  EXPECT_EQ(message_with_walls(coating("30") + coating("30")),
            "j.toml:21: coating[2].thickness_mm = 30: allowed: all coatings "
            "together below the radius of 0.05 m");
  EXPECT_EQ(message_with_walls("[[coating]]\nthickness_um = 5\n"),
            "j.toml:16: coating[1].youngs_modulus is missing: allowed: "
            "youngs_modulus (in Pa), youngs_modulus_Pa, youngs_modulus_kPa, "
            "youngs_modulus_MPa, youngs_modulus_GPa");
  EXPECT_EQ(message_with_walls(coating("0.1") + "[loading]\nkind = \"back\"\n"
                                                "patch_half_angle_deg = 20"),
            "j.toml:21: loading.kind = \"back\": conflicts with [[coating]]: a "
            "coated ball or pin can be loaded at its centre only");

  // Laws of an infinite outer body.
  EXPECT_EQ(
      message_with_walls(wall + layer + "[half_angle]\nlaw = \"tanh\""),
      "j.toml:21: half_angle.law = \"tanh\": finite walls: half-angle law "
      "tanh: allowed: exact");
  for (const std::string law : {"cosine", "mixture"}) {
    EXPECT_EQ(
        message_with_walls(wall + layer + "[pressure]\nlaw = \"" + law + '"'),
        "j.toml:21: pressure.law = \"" + law +
            "\": finite walls: pressure law " + law + ": allowed: exact");
  }
  EXPECT_EQ(message_with_walls(wall + layer +
                               "[half_angle]\nlaw = \"exact\"\n"
                               "[pressure]\nlaw = \"exact\""),
            "(no error)");
}

TEST(JointFile, RigidBodies) {
  std::vector<std::string> lines = good_lines;
  lines[7] = "youngs_modulus_GPa = inf";
  lines[8] = "";
  EXPECT_EQ(parse_joint(text_of(lines), "j.toml").pair.modulus_ratio(),
            infinity);
  lines[10] = "youngs_modulus = inf";
  EXPECT_EQ(error_message([&] { parse_joint(text_of(lines), "j.toml"); }),
            "j.toml:11: materials.outer.youngs_modulus = inf: the inner body "
            "is rigid too: allowed: at most one");
}

TEST(JointFile, SyntaxErrorsHaveTheirLine) {
  const std::string message = message_with_line(4, "radius_mm = = 50");
  EXPECT_EQ(message.substr(0, 10), "j.toml:4: ") << message;
  EXPECT_EQ(message.find('\n'), message.npos);
  // The same key twice is a syntax error of TOML.
  const std::string twice = message_with_line(5, "radius_mm = 50");
  EXPECT_EQ(twice.substr(0, 10), "j.toml:5: ") << twice;
  const std::string utf8 = message_with_line(1, "name = \"\xff\"");
  EXPECT_EQ(utf8.substr(0, 10), "j.toml:1: ") << utf8;
}

// --- Material pair files ----------------------------------------------------

const char* const pair_text =
    "name = \"pair\"\n"
    "[inner]\nyoungs_modulus_GPa = 200\npoissons_ratio = 0.3\n"
    "[outer]\nyoungs_modulus_GPa = 100\npoissons_ratio = 0.34\n"
    "[friction]\ncoefficient = 0.25\n";

TEST(MaterialPairFile, ReadsAndRefuses) {
  const auto pair = parse_material_pair(pair_text, "p.toml");
  EXPECT_EQ(pair.name, "pair");
  EXPECT_EQ(pair.elastic.modulus_ratio(), 2);
  EXPECT_EQ(dry(pair.friction).coefficient(), 0.25);
  const std::string text = std::string(pair_text) + "adhesion_GPa = -3\n";
  EXPECT_EQ(error_message([&] { parse_material_pair(text, "p.toml"); }),
            "p.toml:10: friction.adhesion_GPa = -3: allowed: 0 GPa or above");
  const std::string more = std::string(pair_text) + "[third]\n";
  EXPECT_EQ(error_message([&] { parse_material_pair(more, "p.toml"); }),
            "p.toml:10: third: unknown key: allowed: friction, inner, name, "
            "outer");
}

// A folder of its own for each test, removed at its end.
class JointFolder : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) /
              (std::string("contact_joint_file_") + info->name());
    fs::create_directories(folder_ / "materials");
    fs::create_directories(folder_ / "joints");
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  static std::string joint_text(const std::string& materials) {
    return "name = \"j\"\nkind = \"ball\"\n[geometry]\nradius = 0.05\n"
           "relative_clearance = 1e-3\n" +
           materials;
  }

  fs::path folder_;
};

TEST_F(JointFolder, PairFileByRelativePath) {
  const std::string pair = write("materials/p.toml", pair_text);
  const std::string pair_line = "[materials]\npair = \"../materials/p.toml\"\n";
  const JointSpec joint =
      contact::read_joint(write("joints/j.toml", joint_text(pair_line)));
  EXPECT_EQ(joint.pair.modulus_ratio(), 2);
  // Friction comes from the pair unless the joint has its own.
  EXPECT_EQ(dry(joint.friction).coefficient(), 0.25);
  const JointSpec own = contact::read_joint(
      write("joints/own.toml",
            joint_text(pair_line + "[friction]\ncoefficient = 0.5\n")));
  EXPECT_EQ(dry(own.friction).coefficient(), 0.5);
  const JointSpec absolute = contact::read_joint(
      write("joints/absolute.toml",
            joint_text("[materials]\npair = \"" + pair + "\"\n")));
  EXPECT_EQ(absolute.pair.modulus_ratio(), 2);
}

TEST_F(JointFolder, ErrorsOfThePairFileNameBothFiles) {
  const std::string materials = "[materials]\npair = \"../materials/p.toml\"\n";
  const std::string joint = write("joints/j.toml", joint_text(materials));
  const std::string pair =
      (folder_ / "joints" / "../materials/p.toml").string();
  const auto message = [&] {
    return error_message([&] { contact::read_joint(joint); });
  };
  const std::string place =
      joint + ":7: materials.pair = \"../materials/p.toml\": ";
  EXPECT_EQ(message(),
            place + pair + ": cannot be read: No such file or directory");
  write("materials/p.toml", std::string(pair_text) + "adhesion = true\n");
  EXPECT_EQ(message(),
            place + pair + ":10: friction.adhesion = true: allowed: a number");
  write("joints/j.toml",
        joint_text(materials + "[materials.inner]\nyoungs_modulus = inf\n"));
  EXPECT_EQ(message(),
            place + "allowed: not together with [inner] and [outer]");
}

TEST_F(JointFolder, FilesThatCannotBeRead) {
  const auto message = [](const fs::path& path) {
    return error_message([&] { contact::read_joint(path); });
  };
  EXPECT_EQ(message(folder_ / "none.toml"),
            (folder_ / "none.toml").string() +
                ": cannot be read: No such file or directory");
  EXPECT_EQ(message(folder_),
            folder_.string() + ": cannot be read: not a file");
  EXPECT_EQ(message("/dev/zero"), "/dev/zero: cannot be read: not a file");
  EXPECT_EQ(message("a\nb.toml"),
            "a\\x0ab.toml: cannot be read: control characters are not "
            "allowed");
}

// Every file that comes with the library can be read and used.
TEST(DataFiles, MaterialsAndJoints) {
  std::size_t pairs = 0;
  for (const auto& entry :
       fs::directory_iterator(fs::path(CONTACT_DATA_DIR) / "materials")) {
    const auto pair = contact::read_material_pair(entry.path());
    EXPECT_TRUE(pair.elastic.contact_modulus() > 0) << entry.path();
    ++pairs;
  }
  EXPECT_EQ(pairs, 6u);
  std::size_t joints = 0;
  for (const auto& entry :
       fs::directory_iterator(fs::path(CONTACT_DATA_DIR) / "joints")) {
    const JointSpec joint = contact::read_joint(entry.path());
    ASSERT_TRUE(joint.friction.has_value()) << entry.path();
    const auto result = joint.make_half_angle_law()->half_angle(0.1);
    EXPECT_EQ(result.status, contact::Status::ok) << entry.path();
    EXPECT_TRUE(joint.geometry.validity_notes().empty()) << entry.path();
    ++joints;
  }
  EXPECT_EQ(joints, 9u);
}

TEST(DataFiles, LedgerNamesEveryFile) {
  const fs::path data = CONTACT_DATA_DIR;
  std::ifstream stream(data / "README.md");
  const std::string ledger{std::istreambuf_iterator<char>(stream), {}};
  for (const char* folder :
       {"materials", "backings", "joints", "cases", "reference"}) {
    for (const auto& entry : fs::recursive_directory_iterator(data / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".toml" && extension != ".csv") continue;
      const std::string name =
          fs::relative(entry.path(), data / folder).generic_string();
      EXPECT_NE(ledger.find(name), ledger.npos) << entry.path();
    }
  }
}

// The paper's examples as files: section 5, recomputed values.
TEST(DataFiles, PaperExamples) {
  const fs::path folder = fs::path(CONTACT_DATA_DIR) / "joints";
  const JointSpec one = contact::read_joint(folder / "paper_example_1.toml");
  const double load = one.load_scale().load_parameter(2e5);
  EXPECT_NEAR(load, 0.5460, 5e-5);
  EXPECT_NEAR(one.make_half_angle_law()->half_angle(load).half_angle / degree,
              42.593, 5e-4);
  EXPECT_EQ(dry(one.friction).coefficient(), 0.1);
  EXPECT_DOUBLE_EQ(dry(one.friction).adhesion() / 0.1, 4e8);
  EXPECT_TRUE(one.validity_notes().empty());

  const JointSpec two = contact::read_joint(folder / "paper_example_2.toml");
  const double load_two = two.load_scale().load_parameter(2.5214e5);
  EXPECT_NEAR(
      two.make_half_angle_law()->half_angle(load_two).half_angle / degree,
      45.34, 5e-3);
  EXPECT_EQ(dry(two.friction).coefficient(), 0.25);
  EXPECT_DOUBLE_EQ(dry(two.friction).adhesion() / 0.25, 1e9);
}

// How much the wall matters in a hip at 2 kN: half-angle and peak pressure of
// an independent solution to four digits, beside those of the infinite seat.
TEST(DataFiles, TheWalledHip) {
  const fs::path folder = fs::path(CONTACT_DATA_DIR) / "joints";
  const auto contact_of = [&](const char* file, const std::string& law) {
    JointSpec joint = contact::read_joint(folder / file);
    joint.half_angle_law = joint.pressure_law = law;
    const double half_angle =
        joint.make_half_angle_law()
            ->half_angle(joint.load_scale().load_parameter(2000))
            .half_angle;
    const auto pressure = joint.make_pressure_law();
    return std::array{
        half_angle / degree,
        joint.geometry.pressure_unit(2000) * pressure->peak(half_angle) / 1e6,
        pressure->force_ratio(half_angle)};
  };
  const auto walled = contact_of("hip_cocr_uhmwpe_walled.toml", "exact");
  EXPECT_NEAR(walled[0], 43.47, 5e-3);
  EXPECT_NEAR(walled[1], 11.33, 5e-3);
  EXPECT_NEAR(walled[2], 1.115, 5e-4);
  const auto infinite = contact_of("hip_cocr_uhmwpe.toml", "exact");
  EXPECT_NEAR(infinite[0], 48.05, 5e-3);
  EXPECT_NEAR(infinite[1], 8.84, 5e-3);
  EXPECT_NEAR(infinite[2], 1.149, 5e-4);

  const JointSpec hip =
      contact::read_joint(folder / "hip_cocr_uhmwpe_walled.toml");
  const contact::ContactApproach approach =
      contact::BallContact(*hip.conditions.walls).approach(walled[0] * degree);
  EXPECT_NEAR(approach.approach * hip.geometry.radial_clearance(), 45.7e-6,
              5e-8);
  EXPECT_NEAR(
      approach.stiffness * hip.geometry.radius() * hip.pair.effective_modulus(),
      7.03e7, 5e4);
}

// The same of a liner of 0.4 mm on steel and of a bush in a free housing.
TEST(DataFiles, LinerAndBush) {
  const auto file = [](const std::string& kind, const std::string& outer,
                       const std::string& wall) {
    return "name = \"j\"\nkind = \"" + kind +
           "\"\n[geometry]\nradius_mm = 25\nradial_clearance_um = 25\n" +
           (kind == "pin" ? "length = 1\n" : "") +
           "[materials.inner]\nyoungs_modulus_GPa = 210\n"
           "poissons_ratio = 0.3\n[materials.outer]\n" +
           outer + "[wall]\n" + wall;
  };
  const auto check = [](const std::string& text, double load, double half_angle,
                        double megapascal) {
    const JointSpec joint = parse_joint(text, "j.toml");
    const double found =
        joint.make_half_angle_law()
            ->half_angle(joint.load_scale().load_parameter(load))
            .half_angle;
    EXPECT_NEAR(found / degree, half_angle, 5e-3);
    EXPECT_NEAR(joint.geometry.pressure_unit(load) *
                    joint.make_pressure_law()->peak(found) / 1e6,
                megapascal, 0.05);
  };
  const std::string liner =
      file("ball", "youngs_modulus_GPa = 1\npoissons_ratio = 0.42\n",
           "backing = { youngs_modulus_GPa = 210, poissons_ratio = 0.3 }\n"
           "[[wall.layer]]\nthickness_mm = 0.4\n");
  check(liner, 2e4, 44.54, 37.2);
  const std::string bush =
      file("pin", "youngs_modulus_GPa = 110\npoissons_ratio = 0.34\n",
           "backing = \"held\"\n[[wall.layer]]\nthickness_mm = 5\n"
           "[[wall.layer]]\nthickness_mm = 25\n"
           "youngs_modulus_GPa = 210\npoissons_ratio = 0.3\n");
  check(bush, 2e6, 56.74, 54.4);
}

// --- The reader itself ------------------------------------------------------

TEST(TomlTable, EveryUnit) {
  const auto value = [](const std::string& key, Dimension dimension) {
    const auto table = TomlTable::from_text("q" + key + " = 3", "t.toml");
    return table.number("q", Interval::any(), dimension);
  };
  const auto expect =
      [&](Dimension dimension,
          const std::vector<std::pair<std::string, double>>& expected) {
        EXPECT_EQ(value("", dimension), expected.front().second);
        for (const auto& [ending, si] : expected) {
          EXPECT_DOUBLE_EQ(value("_" + ending, dimension), si) << ending;
        }
      };
  const double pi = std::acos(-1.0);
  expect(Dimension::length,
         {{"m", 3}, {"mm", 3e-3}, {"um", 3e-6}, {"km", 3e3}});
  expect(Dimension::stress,
         {{"Pa", 3}, {"kPa", 3e3}, {"MPa", 3e6}, {"GPa", 3e9}});
  expect(Dimension::force, {{"N", 3}, {"kN", 3e3}, {"MN", 3e6}});
  expect(Dimension::line_force,
         {{"N_per_m", 3}, {"kN_per_m", 3e3}, {"N_per_mm", 3e3}});
  expect(Dimension::moment, {{"N_m", 3}, {"kN_m", 3e3}, {"N_mm", 3e-3}});
  expect(Dimension::angle, {{"rad", 3}, {"deg", pi / 60}});
  expect(Dimension::angular_velocity,
         {{"rad_per_s", 3}, {"deg_per_s", pi / 60}, {"rpm", pi / 10}});
  expect(Dimension::angular_acceleration,
         {{"rad_per_s2", 3}, {"deg_per_s2", pi / 60}});
  expect(Dimension::velocity,
         {{"m_per_s", 3}, {"mm_per_s", 3e-3}, {"km_per_h", 3 / 3.6}});
  expect(Dimension::acceleration, {{"m_per_s2", 3}});
  expect(Dimension::time, {{"s", 3}, {"ms", 3e-3}});
  expect(Dimension::mass, {{"kg", 3}, {"g", 3e-3}, {"t", 3e3}});
  expect(Dimension::inertia, {{"kg_m2", 3}});
  expect(Dimension::viscous_constant, {{"Pa_s_per_m", 3},
                                       {"kPa_s_per_m", 3e3},
                                       {"MPa_s_per_m", 3e6},
                                       {"GPa_s_per_m", 3e9}});
  expect(Dimension::inverse_velocity, {{"s_per_m", 3}});
  EXPECT_EQ(value("", Dimension::number), 3);
}

TEST(TomlTable, LongArraysAreCutInMessages) {
  const auto table = TomlTable::from_text(
      "a = [\"one\", 2.5, true, [100000, 200000, 300000, 400000, 500000, "
      "600000], 7, 8, 9]\n",
      "t.toml");
  EXPECT_EQ(error_message([&] { table.fail("a", "no"); }),
            "t.toml:1: a: no");  // not asked for yet
  EXPECT_TRUE(table.has("a"));
  EXPECT_EQ(error_message([&] { table.fail("a", "no"); }),
            "t.toml:1: a = [\"one\", 2.5, true, ... 7 in all]: no");
}

TEST(TomlTable, ArraysMatricesIntegersFlags) {
  const auto table = TomlTable::from_text(
      "v_mm = [1, 2.5, -3]\n"
      "m_kg_m2 = [[1, 2], [3, 4]]\n"
      "n = 7\nflag = true\nword = \"b\"\n"
      "[[item]]\nx = 1\n[[item]]\nx = 2\n",
      "t.toml");
  EXPECT_EQ(table.numbers("v", 3, Interval::any(), Dimension::length),
            (std::vector<double>{1e-3, 2.5e-3, -3e-3}));
  EXPECT_EQ(table.matrix("m", 2, 2, Interval::any(), Dimension::inertia),
            (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(table.integer("n", 0, 7), 7);
  EXPECT_TRUE(table.boolean("flag"));
  EXPECT_EQ(table.choice("word", {"a", "b"}), 1u);
  const auto items = table.tables("item");
  ASSERT_EQ(items.size(), 2u);
  EXPECT_EQ(items[1].number("x", Interval::any()), 2);
  EXPECT_TRUE(table.tables("none").empty());
  EXPECT_EQ(error_message([&] { table.refuse_unknown_keys(); }),
            "t.toml:7: item[1].x: unknown key: allowed: ");
  EXPECT_EQ(items[0].number("x", Interval::any()), 1);
  EXPECT_EQ(error_message([&] { table.refuse_unknown_keys(); }), "(no error)");

  EXPECT_EQ(error_message([&] {
              table.numbers("v", 2, Interval::any(), Dimension::length);
            }),
            "t.toml:1: v_mm = [1, 2.5, -3]: allowed: an array of 2 numbers");
  EXPECT_EQ(error_message([&] {
              table.numbers("v", 3, Interval::positive(), Dimension::length);
            }),
            "t.toml:1: v_mm[3] = -3: allowed: above 0 mm");
  EXPECT_EQ(error_message([&] {
              table.matrix("m", 3, 3, Interval::any(), Dimension::inertia);
            }),
            "t.toml:2: m_kg_m2 = [[1, 2], [3, 4]]: allowed: an array of 3 "
            "arrays of 3 numbers");
  EXPECT_EQ(error_message([&] {
              table.matrix("m", 2, 2, Interval{0, 3}, Dimension::inertia);
            }),
            "t.toml:2: m_kg_m2[2][2] = 4: allowed: 0 to 3 kg m^2");
  EXPECT_EQ(error_message([&] { table.integer("n", 0, 6); }),
            "t.toml:3: n = 7: allowed: an integer, 0 to 6");
  EXPECT_EQ(error_message([&] { table.boolean("n"); }),
            "t.toml:3: n = 7: allowed: true or false");
  EXPECT_EQ(error_message([&] { table.integer("flag", 0, 6); }),
            "t.toml:4: flag = true: allowed: an integer, 0 to 6");
  EXPECT_EQ(error_message([&] { table.tables("n"); }),
            "t.toml:3: n = 7: allowed: an array of tables");
  EXPECT_EQ(error_message([&] { table.table("n"); }),
            "t.toml:3: n = 7: allowed: a table");
  EXPECT_EQ(error_message([&] { items[1].fail("x", "too many"); }),
            "t.toml:9: item[2].x = 2: too many");
  EXPECT_EQ(error_message([&] { items[1].fail("y", "no y"); }),
            "t.toml:8: item[2].y: no y");
}

TEST(TomlTable, ValuesInMessagesStayShort) {
  const auto shown = [](const std::string& value) {
    const auto table = TomlTable::from_text("x = " + value, "t");
    const std::string message =
        error_message([&] { table.number("x", Interval::any()); });
    return message.substr(9, message.find(": allowed") - 9);
  };
  EXPECT_EQ(shown("[]"), "[]");
  EXPECT_EQ(shown("[1, \"a\", true, [0.5], {y = 1}]"),
            "[1, \"a\", true, [0.5], a table]");
  std::string long_array = "[0";
  for (int i = 1; i < 500; ++i) long_array += ", " + std::to_string(i);
  EXPECT_EQ(shown(long_array + ']'),
            "[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, "
            "17, ... 500 in all]");
  EXPECT_EQ(shown("07:32:00"), "07:32:00");
  EXPECT_EQ(shown("1979-05-27T07:32:00Z"), "1979-05-27T07:32:00Z");
  EXPECT_EQ(error_message([] {
              TomlTable::from_text("x = [[1, 2], [3, true]]", "t")
                  .rows("x", 1, 2, Interval::any());
            }),
            "t:1: x[2][2] = true: allowed: a number");
}

TEST(TomlTable, RangesReadAsSentences) {
  const auto table = TomlTable::from_text("x = nan", "t");
  const auto allowed = [&](const Interval& interval) {
    const std::string message =
        error_message([&] { table.number("x", interval); });
    return message.substr(message.find("allowed: ") + 9);
  };
  EXPECT_EQ(allowed(Interval::any()), "a finite number");
  EXPECT_EQ(allowed(Interval::positive()), "above 0");
  EXPECT_EQ(allowed(Interval::non_negative()), "0 or above");
  EXPECT_EQ(allowed({1, 2}), "1 to 2");
  EXPECT_EQ(allowed({1, 2, true, true}), "above 1, below 2");
  EXPECT_EQ(allowed({1, 2, true, false}), "above 1, up to 2");
  EXPECT_EQ(allowed({1, 2, false, true}), "from 1, below 2");
  EXPECT_EQ(allowed({-Interval::largest, 2}), "up to 2");
  EXPECT_EQ(allowed({-Interval::largest, 2, false, true}), "below 2");
}

TEST(TomlTable, OutlivesItsParent) {
  const TomlTable inner = [] {
    return TomlTable::from_text("[a]\nx = 1", "t").table("a");
  }();
  EXPECT_EQ(inner.number("x", Interval::any()), 1);
  EXPECT_EQ(inner.source(), "t");
}

TEST(SharedLaws, AreThoseOfJointsThatAreAlike) {
  contact::SharedLaws laws;
  const auto half_angle = [&](const JointSpec& joint) {
    return laws.half_angle(joint).get();
  };
  const auto pressure = [&](const JointSpec& joint) {
    return laws.pressure(joint).get();
  };
  const fs::path folder = fs::path(CONTACT_DATA_DIR) / "joints";
  const JointSpec joint = contact::read_joint(folder / "wheel_ball.toml");
  JointSpec other = joint;
  other.name = "another";
  EXPECT_EQ(half_angle(other), half_angle(joint));
  EXPECT_EQ(pressure(other), pressure(joint));
  other.half_angle_law = "tanh";
  EXPECT_NE(half_angle(other), half_angle(joint));
  JointSpec third = other;
  third.half_angle_options.limit_half_angle = 1;
  EXPECT_NE(half_angle(third), half_angle(other));
  EXPECT_EQ(pressure(third), pressure(joint));
  third.pressure_law = "exact";
  EXPECT_NE(pressure(third), pressure(joint));
  for (const char* file : {"wheel_pin.toml", "hip_cocr_uhmwpe.toml",
                           "hip_cocr_uhmwpe_walled.toml"}) {
    const JointSpec unlike = contact::read_joint(folder / file);
    EXPECT_NE(half_angle(unlike), half_angle(joint)) << file;
    EXPECT_NE(pressure(unlike), pressure(joint)) << file;
  }
}

}  // namespace
