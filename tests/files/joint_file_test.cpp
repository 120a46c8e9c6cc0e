#include "libcontact/files/joint_file.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/conforming/ball.hpp"
#include "libcontact/files/joint_tables.hpp"
#include "libcontact/files/named_file.hpp"
#include "libcontact/half_angle/exact.hpp"
#include "libcontact/pressure/exact.hpp"
#include "support/edited_file.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"
#include "support/program.hpp"

namespace contact::test::joint_file_test {
namespace {

namespace fs = std::filesystem;

EditedFile ball_file() { return EditedFile("ball.toml"); }

// A joint of data/joints.
JointSpec sample_joint(const std::string& name) {
  return read_joint(CONTACT_DATA_DIR "/joints/" + name + ".toml");
}

JointSpec parsed(const EditedFile& file) {
  return parse_joint(file.text(), "j.toml");
}

const FrictionLaw& dry(const std::optional<FrictionModel>& friction) {
  return std::get<FrictionLaw>(friction.value());
}

const ViscousLaw& viscous(const std::optional<FrictionModel>& friction) {
  return std::get<ViscousLaw>(friction.value());
}

TEST(JointFile, ReadsEverything) {
  const JointSpec joint = parsed(ball_file());
  EXPECT_EQ(joint.name, "test joint");
  EXPECT_EQ(joint.geometry.kind(), JointKind::ball);
  EXPECT_EQ(joint.geometry.inner_body(), JointBody::carrier);
  // Units by exact powers of ten: the doubles nearest to the decimals.
  EXPECT_EQ(joint.geometry.radius(), 0.05);
  EXPECT_EQ(joint.geometry.radial_clearance(), 50e-6);
  EXPECT_EQ(joint.pair().inner().name, "steel");
  EXPECT_EQ(joint.pair().inner().youngs_modulus, 2e11);
  EXPECT_EQ(joint.pair().outer().youngs_modulus, 1.1e11);
  EXPECT_EQ(joint.pair().outer().poissons_ratio, 0.34);
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
  EXPECT_EQ(joint.pair().inner().youngs_modulus, 2.1e11);
  EXPECT_EQ(joint.pair().modulus_ratio(), 0);
  EXPECT_FALSE(joint.friction.has_value());
  EXPECT_EQ(joint.half_angle_law, "paper");
  EXPECT_EQ(joint.pressure_law, default_pressure_law);
  EXPECT_EQ(joint.half_angle_options.initial_slope, 57.3 * degree);
  EXPECT_EQ(joint.validity_notes().size(), 1u);  // a blend, modulus ratio 0
}

TEST(JointFile, DiametersAreTwiceTheRadii) {
  const auto geometry = [](const std::string& size,
                           const std::string& clearance) {
    const JointSpec joint =
        parsed(ball_file().edit("4", size).edit("5", clearance));
    EXPECT_FALSE(joint.fit.has_value());
    EXPECT_EQ(joint.geometry.radius(), 0.05) << size;
    EXPECT_EQ(joint.geometry.radial_clearance(), 50e-6) << clearance;
  };
  geometry("diameter_mm = 100", "radial_clearance_um = 50");
  geometry("diameter = 0.1", "diametral_clearance_um = 100");
  geometry("radius_mm = 50", "diametral_clearance_mm = 0.1");
  geometry("diameter_um = 100000", "relative_clearance = 0.001");
}

TEST(JointFile, Fit) {
  const auto joint = [](const std::string& clearance) {
    return parsed(
        ball_file()
            .edit("4", "diameter_mm = 50")
            .edit("5", "hole = \"H7\"\nshaft = \"g6\"\n" + clearance));
  };
  // H7/g6 of 50 mm: 9 to 50 um of the diameters.
  const JointSpec mean = joint("");
  EXPECT_EQ(mean.fit.value().name(), "H7/g6");
  EXPECT_EQ(mean.geometry.radius(), 0.0249915);
  EXPECT_EQ(mean.geometry.radial_clearance(), 14.75e-6);
  EXPECT_EQ(joint("clearance = \"mean\"").geometry.radial_clearance(),
            14.75e-6);
  EXPECT_EQ(joint("clearance = \"minimum\"").geometry.radial_clearance(),
            4.5e-6);
  const JointSpec maximum = joint("clearance = \"maximum\"");
  EXPECT_EQ(maximum.geometry.radial_clearance(), 25e-6);
  EXPECT_EQ(maximum.fit.value().taken(), contact::Fit::Clearance::maximum);
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
  EXPECT_EQ(joint.half_angle_law, default_half_angle_law);
  EXPECT_EQ(joint.make_half_angle_law()->name(), "fitted");
  EXPECT_TRUE(joint.validity_notes().empty());
}

TEST(JointFile, ViscousFriction) {
  const auto friction = [](const std::string& first,
                           const std::string& second) {
    return parsed(ball_file().edit("14", first).edit("15", second)).friction;
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
}

TEST(JointFile, Loading) {
  const EditedFile exact = ball_file()
                               .edit("17", "law = \"exact\"")
                               .edit("18", "")
                               .edit("20", "law = \"exact\"");
  const auto loaded = [&](const std::string& keys) {
    return parsed(EditedFile(exact).edit("+", "[loading]\n" + keys));
  };
  const JointSpec joint = loaded("kind = \"back\"\npatch_half_angle_deg = 20");
  const auto loading = InnerLoading::back(20 * degree);
  EXPECT_EQ(joint.conditions().loading, loading);
  const ExactLaw law(JointKind::ball, joint.pair(), loading);
  EXPECT_EQ(joint.make_half_angle_law()->half_angle(3).half_angle,
            law.half_angle(3).half_angle);
  const ExactPressure pressure(JointKind::ball, joint.pair(), loading);
  EXPECT_EQ(joint.make_pressure_law()->peak(1), pressure.peak(1));
  const auto centre = InnerLoading::centre();
  EXPECT_EQ(parsed(ball_file()).conditions().loading, centre);
  EXPECT_EQ(loaded("kind = \"centre\"").conditions().loading, centre);
}

// The file with walls in place of its laws.
JointSpec walled(const std::string& walls) {
  return parsed(ball_file().edit("16...", walls));
}

// A pin in a plate, by Hertz' compliance of plane stress, 1/E, which equals
// plane strain of the materials taken, (1 - nu'^2)/E'; the shear modulus stays.
TEST(JointFile, PlaneStressOfPins) {
  const auto read = [](const std::string& key, const std::string& wall = "") {
    return parse_joint(key + R"(
        name = "pin in a plate"
        kind = "pin"
        geometry = { radius_mm = 30, radial_clearance_um = 5, length_mm = 1 }
        materials.inner = { youngs_modulus_GPa = 210, poissons_ratio = 0.3 }
        materials.outer = { youngs_modulus_GPa = 70, poissons_ratio = 0.5 }
        )" + wall,
                       "plate.toml");
  };
  const JointSpec strain = read("plane_state = \"strain\"");
  EXPECT_EQ(strain, read(""));
  const JointSpec stress = read("plane_state = \"stress\"");
  const auto compliance = [](const Material& m) {
    return (1 - m.poissons_ratio * m.poissons_ratio) / m.youngs_modulus;
  };
  const auto shear = [](const Material& m) {
    return m.youngs_modulus / (2 * (1 + m.poissons_ratio));
  };
  // 4 roundings.
  constexpr double rounding = 4 * 2.3e-16;
  for (const auto body : {&JointSpec::inner, &JointSpec::outer}) {
    const Material& given = (strain.*body).surface();
    const Material& taken = (stress.*body).surface();
    EXPECT_NEAR(compliance(taken) * given.youngs_modulus, 1, rounding);
    EXPECT_NEAR(shear(taken) / shear(given), 1, rounding);
  }
  EXPECT_EQ(parse_joint(stress.canonical_text(), "text"), stress);

  const std::string wall =
      "wall.backing = { youngs_modulus_GPa = 3, poissons_ratio = 0.4 }\n"
      "[[wall.layer]]\nthickness_mm = 2\n";
  const JointSpec plate = read("plane_state = \"stress\"", wall);
  EXPECT_EQ(plate.outer.layers[0].material, stress.outer.surface());
  EXPECT_NEAR(compliance(plate.outer.backing.material()) * 3e9, 1, rounding);
  EXPECT_ERROR(read("plane_state = \"stress\"\ntemperature_C = 40"),
               "plate.toml:1: plane_state = \"stress\" conflicts with "
               "temperature_C (line 2)");
}

TEST(JointFile, SeatsThatEnd) {
  const auto seat = [](const std::string& keys) {
    return parsed(ball_file().edit("+", "[seat]\n" + keys)).geometry.seat();
  };
  EXPECT_FALSE(parsed(ball_file()).geometry.seat());
  EXPECT_EQ(seat("ring_width_mm = 28"), SeatZone::ring(0.028, 0.05));
  EXPECT_EQ(seat("cup_rad = 1"), SeatZone::cup(1));
  EXPECT_EQ(seat("lower_rim_rad = 0.5\nupper_rim_rad = 2"), SeatZone(0.5, 2));
  EXPECT_EQ(seat("cup_rad = 1\nrim_setback_rad = 0.1"),
            SeatZone::cup(1).moved_in(0.1));
  EXPECT_EQ(seat("cup_rad = 1\naxis = [0, 3, -4]"),
            SeatZone::cup(1).about({0, 0.6, -0.8}));
  EXPECT_EQ(seat("cup_rad = 1\nedge_radius_um = 500\nedge_angle_rad = 1.5\n"
                 "report_distance_rad = 0.03"),
            SeatZone::cup(1).with_edge({500e-6, 1.5, 0.03}));
  const auto free = parsed(
      ball_file().edit("+", "[seat]\ncup_rad = 1\nside_face = \"free\""));
  EXPECT_EQ(free.geometry.seat()->edge().side_face, SideFace::free);
  EXPECT_EQ(parse_joint(free.canonical_text(), "text"), free);
  EXPECT_EQ(seat("cup_rad = 1\nside_face = \"goes_on\""), SeatZone::cup(1));
  const auto housed =
      parsed(ball_file().edit("+", "[seat]\ncup_rad = 1\nhousing = \"free\""));
  EXPECT_EQ(housed.geometry.seat()->edge().housing, SideFace::free);
  EXPECT_EQ(parse_joint(housed.canonical_text(), "text"), housed);
  EXPECT_ERROR(seat("cup_deg = 80\nside_face = \"free\"\nrim_setback_deg = 2"),
               "j.toml:23: seat.side_face = \"free\" conflicts with "
               "seat.rim_setback_deg (line 24)");
  EXPECT_ERROR(seat("cup_deg = 80\nhousing = \"ends\""),
               "j.toml:23: seat.housing = \"ends\" must be \"goes_on\" or "
               "\"free\"");
  const JointSpec turned =
      parsed(ball_file().edit("+",
                              "[seat]\ncup_rad = 1\nrim_setback_rad = 0.07\n"
                              "edge_radius_mm = 1\nedge_angle_rad = 2\n"
                              "report_distance_rad = 0.03\n"
                              "axis = [1, 2, -3]"));
  EXPECT_EQ(parse_joint(turned.canonical_text(), "text"), turned);
  // The default law is the joint's.
  JointSpec unnamed = turned;
  unnamed.half_angle_law = "";
  unnamed.half_angle_options = {};
  EXPECT_EQ(unnamed.half_angle_law_name(), "exact");
  const JointSpec endless = unnamed.without_seat();
  EXPECT_EQ(endless.half_angle_law_name(), default_half_angle_law);
  EXPECT_FALSE(parse_joint(endless.canonical_text(), "text").geometry.seat());
  const JointSpec left_out =
      parsed(ball_file().edit("+", "[seat]\ncup_rad = 1\nleft_out = true\n"));
  EXPECT_FALSE(left_out.geometry.seat());
  EXPECT_EQ(left_out.geometry.drawn_seat(), SeatZone::cup(1));
  EXPECT_TRUE(seat("cup_rad = 1\nleft_out = false"));
  EXPECT_ERROR(seat("cup_rad = 1\nleft_out = 1"),
               "j.toml:23: seat.left_out = 1 must be true or false");
  EXPECT_ERROR(
      seat("cup_deg = 80\nupper_rim_deg = 90"),
      "j.toml:22: seat.cup_deg = 80 conflicts with seat.upper_rim_deg (line "
      "23)");
  EXPECT_ERROR(
      seat("cup_deg = 8\nrim_setback_deg = 7.5"),
      "j.toml:23: seat.rim_setback_deg = 7.5: seat: width after the "
      "setback = 0.00872664625997166 must be at least 1 deg (0.01745 rad)");
  EXPECT_ERROR(seat("cup_deg = 80\nedge_radius_mm = 60"),
               "j.toml:23: seat.edge_radius_mm = 60 must be from 0 and "
               "below 50 mm");
  EXPECT_ERROR(
      seat("cup_deg = 80\naxis = [0, 0, 0]"),
      "j.toml:23: seat.axis = [0, 0, 0] must be a vector that is not 0");
}

TEST(JointFile, Walls) {
  const JointSpec joint = walled(
      "[wall]\n"
      "backing = { youngs_modulus_GPa = 120, poissons_ratio = 0.25 }\n"
      "[[wall.layer]]\nthickness_mm = 3\n"
      "[[wall.layer]]\nthickness_um = 40\n"
      "youngs_modulus_GPa = 2\npoissons_ratio = 0.4\n"
      "[[coating]]\nthickness_um = 500\n"
      "youngs_modulus_GPa = 300\npoissons_ratio = 0.2\n");
  ASSERT_TRUE(joint.conditions().walls.has_value());
  const LayeredPair walls = joint.conditions().walls.value();
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
  // The pair belongs to the surfaces, and the laws support walls.
  EXPECT_EQ(joint.pair().inner().youngs_modulus, 3e11);
  EXPECT_EQ(joint.pair().outer().youngs_modulus, 1.1e11);
  EXPECT_EQ(joint.half_angle_law, "exact");
  EXPECT_EQ(joint.pressure_law, "exact");
  const ExactLaw law(JointKind::ball, walls);
  EXPECT_EQ(joint.make_half_angle_law()->half_angle(3).half_angle,
            law.half_angle(3).half_angle);
  EXPECT_NE(law.half_angle(3).half_angle,
            ExactLaw(JointKind::ball, joint.pair()).half_angle(3).half_angle);
  const ExactPressure pressure(JointKind::ball, walls);
  EXPECT_EQ(joint.make_pressure_law()->peak(1), pressure.peak(1));

  // A first layer with a material of its own; loading through the back.
  const JointSpec own = walled(
      "[wall]\nbacking = \"held\"\n[[wall.layer]]\n"
      "thickness_mm = 30\nyoungs_modulus_GPa = 3\n"
      "poissons_ratio = 0.5\n"
      "[loading]\nkind = \"back\"\npatch_half_angle_deg = 10");
  EXPECT_EQ(own.pair().outer().youngs_modulus, 3e9);
  EXPECT_EQ(own.conditions().walls->outer().backing.kind(),
            Backing::Kind::held);
  EXPECT_TRUE(own.conditions().loading.is_back());
  EXPECT_TRUE(own.conditions().walls->inner().layers.empty());

  // A coating alone.
  const JointSpec coated = walled(
      "[[coating]]\nthickness_mm = 1\n"
      "youngs_modulus_GPa = 3\npoissons_ratio = 0.3");
  EXPECT_TRUE(coated.conditions().walls->outer().layers.empty());
  EXPECT_EQ(coated.half_angle_law, "exact");
}

TEST(JointFile, RigidBody) {
  const EditedFile file =
      ball_file().edit("8", "youngs_modulus_GPa = inf").edit("9", "");
  EXPECT_EQ(parsed(file).pair().modulus_ratio(), infinity);
}

TEST(JointFile, TextThatIsNotUtf8HasItsLine) {
  const std::string message =
      error_message([] { parsed(ball_file().edit("1", "name = \"\xff\"")); });
  EXPECT_EQ(message.substr(0, 10), "j.toml:1: ") << message;
}

// --- Material pair files ----------------------------------------------------

const std::string pair_text = EditedFile("pair.toml").text();

TEST(MaterialPairFile, Reads) {
  const auto pair = parse_material_pair(pair_text, "p.toml");
  EXPECT_EQ(pair.name, "pair");
  EXPECT_EQ(pair.elastic.modulus_ratio(), 2);
  EXPECT_EQ(dry(pair.friction).coefficient(), 0.25);
}

// A folder of its own for each test, removed at its end.
class JointFolder : public testing::Test {
 protected:
  JointFolder() {
    fs::create_directories(folder_ / "materials");
    fs::create_directories(folder_ / "joints");
  }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  static std::string joint_text(const std::string& materials) {
    return "name = \"j\"\nkind = \"ball\"\n[geometry]\nradius = 0.05\n"
           "relative_clearance = 1e-3\n" +
           materials;
  }

  const ProgramFolder owner_;
  const fs::path folder_ = owner_.path();
};

TEST_F(JointFolder, PairFileByRelativePath) {
  const std::string pair = write("materials/p.toml", pair_text);
  const std::string pair_line = "[materials]\npair = \"../materials/p.toml\"\n";
  const JointSpec joint =
      read_joint(write("joints/j.toml", joint_text(pair_line)));
  EXPECT_EQ(joint.pair().modulus_ratio(), 2);
  // Friction comes from the pair unless the joint has its own.
  EXPECT_EQ(dry(joint.friction).coefficient(), 0.25);
  const JointSpec own = read_joint(
      write("joints/own.toml",
            joint_text(pair_line + "[friction]\ncoefficient = 0.5\n")));
  EXPECT_EQ(dry(own.friction).coefficient(), 0.5);
  const JointSpec absolute =
      read_joint(write("joints/absolute.toml",
                       joint_text("[materials]\npair = \"" + pair + "\"\n")));
  EXPECT_EQ(absolute.pair().modulus_ratio(), 2);
}

TEST_F(JointFolder, ErrorsOfThePairFileNameBothFiles) {
  const std::string materials = "[materials]\npair = \"../materials/p.toml\"\n";
  const std::string joint = write("joints/j.toml", joint_text(materials));
  const std::string pair =
      (folder_ / "joints" / "../materials/p.toml").string();
  const auto message = [&] {
    return error_message([&] { read_joint(joint); });
  };
  const std::string place =
      joint + ":7: materials.pair = \"../materials/p.toml\": ";
  EXPECT_EQ(message(),
            place + pair + ": cannot be read: No such file or directory");
  write("materials/p.toml", pair_text + "adhesion = true\n");
  EXPECT_EQ(message(),
            place + pair + ":10: friction.adhesion = true must be a number");
  write("joints/j.toml",
        joint_text(materials + "[materials.inner]\nyoungs_modulus = inf\n"));
  EXPECT_EQ(message(),
            joint +
                ":7: materials.pair = \"../materials/p.toml\" conflicts "
                "with materials.inner (line 8)");
}

TEST_F(JointFolder, FilesThatCannotBeRead) {
  const auto message = [](const fs::path& path) {
    return error_message([&] { read_joint(path); });
  };
  EXPECT_EQ(message(folder_ / "none.toml"),
            (folder_ / "none.toml").string() +
                ": cannot be read: No such file or directory");
  EXPECT_EQ(message(folder_),
            folder_.string() + ": cannot be read: a directory");
  EXPECT_EQ(message("/dev/zero"), "/dev/zero: cannot be read: not a file");
  EXPECT_EQ(message("a\nb.toml"),
            "a\\x0ab.toml: cannot be read: its name has control characters");
}

// Every file that comes with the library can be read and used.
TEST(DataFiles, MaterialsAndJoints) {
  std::size_t pairs = 0;
  for (const auto& entry :
       fs::directory_iterator(fs::path(CONTACT_DATA_DIR) / "materials")) {
    const auto pair = read_material_pair(entry.path());
    EXPECT_TRUE(pair.elastic.contact_modulus() > 0) << entry.path();
    ++pairs;
  }
  EXPECT_EQ(pairs, 6u);
  std::size_t joints = 0;
  for (const auto& entry :
       fs::directory_iterator(fs::path(CONTACT_DATA_DIR) / "joints")) {
    const JointSpec joint = read_joint(entry.path());
    ASSERT_TRUE(joint.friction.has_value()) << entry.path();
    const auto result = joint.make_half_angle_law()->half_angle(0.1);
    EXPECT_EQ(result.status, Status::ok) << entry.path();
    // Interference always has a note on its neglected effects.
    EXPECT_EQ(joint.geometry.validity_notes().empty(),
              joint.geometry.radial_clearance() > 0)
        << entry.path();
    ++joints;
  }
  EXPECT_EQ(joints, 18u);
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
      EXPECT_TRUE(has_text(ledger, name)) << entry.path();
    }
  }
}

// The paper's examples as files: section 5, recomputed values.
TEST(DataFiles, PaperExamples) {
  const JointSpec one = sample_joint("paper_example_1");
  const double load = one.load_scale().load_parameter(2e5);
  EXPECT_NEAR(load, 0.5460, 5e-5);
  EXPECT_NEAR(one.make_half_angle_law()->half_angle(load).half_angle / degree,
              42.593, 5e-4);
  EXPECT_EQ(dry(one.friction).coefficient(), 0.1);
  EXPECT_DOUBLE_EQ(dry(one.friction).adhesion() / 0.1, 4e8);
  EXPECT_TRUE(one.validity_notes().empty());

  const JointSpec two = sample_joint("paper_example_2");
  const double load_two = two.load_scale().load_parameter(2.5214e5);
  EXPECT_NEAR(
      two.make_half_angle_law()->half_angle(load_two).half_angle / degree,
      45.34, 5e-3);
  EXPECT_EQ(dry(two.friction).coefficient(), 0.25);
  EXPECT_DOUBLE_EQ(dry(two.friction).adhesion() / 0.25, 1e9);
}

// How much the wall matters in a hip at 2 kN: half-angle and peak pressure of
// an independent solution to four digits, and of the infinite seat.
TEST(DataFiles, TheWalledHip) {
  const auto contact_of = [&](const char* name, const std::string& law) {
    JointSpec joint = sample_joint(name);
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
  const auto walled = contact_of("hip_cocr_uhmwpe", "exact");
  EXPECT_NEAR(walled[0], 43.47, 5e-3);
  EXPECT_NEAR(walled[1], 11.33, 5e-3);
  EXPECT_NEAR(walled[2], 1.115, 5e-4);
  const auto infinite = contact_of("hip_cocr_uhmwpe_infinite", "exact");
  EXPECT_NEAR(infinite[0], 48.05, 5e-3);
  EXPECT_NEAR(infinite[1], 8.84, 5e-3);
  EXPECT_NEAR(infinite[2], 1.149, 5e-4);

  const JointSpec hip = sample_joint("hip_cocr_uhmwpe");
  const ContactApproach approach =
      BallContact(*hip.conditions().walls).approach(walled[0] * degree);
  EXPECT_NEAR(approach.approach * hip.geometry.radial_clearance(), 45.7e-6,
              5e-8);
  EXPECT_NEAR(approach.stiffness * hip.geometry.radius() *
                  hip.pair().effective_modulus(),
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
    const auto table =
        TomlTable::from_text("q" + key + " = 3", "t.toml", {{"q", dimension}});
    return table.number("q", Interval::any());
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
  expect(Dimension::length, {{"m", 3},
                             {"mm", 3e-3},
                             {"um", 3e-6},
                             {"cm", 0.03},
                             {"in", 0.0762},
                             {"km", 3e3}});
  expect(Dimension::stress, {{"Pa", 3},
                             {"kPa", 3e3},
                             {"MPa", 3e6},
                             {"GPa", 3e9},
                             {"psi", 3 * 4.4482216152605 / (0.0254 * 0.0254)}});
  expect(Dimension::force,
         {{"N", 3}, {"kN", 3e3}, {"MN", 3e6}, {"lbf", 13.3446648457815}});
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
      "t.toml", {{"a"}, {"b"}});
  EXPECT_ERROR(table.fail("b", "no"), "t.toml:1: b: no");
  EXPECT_TRUE(table.has("a"));
  EXPECT_ERROR(table.fail("a", "no"),
               "t.toml:1: a = [\"one\", 2.5, true, ... 7 in all]: no");
}

TEST(TomlTable, SettingsOfElementsAndFactors) {
  const KnownKeys keys = {{"v", Dimension::length}, {"m"}, {"n"}};
  const std::string text = "v_mm = [1, 2.5, -3]\nm = [[1, 2], [3, 4]]\nn = 7\n";
  const auto with = [&](const std::string& key, const std::string& value) {
    return TomlTable::from_text(text, "t.toml", keys, {}, {{key, value}});
  };
  EXPECT_EQ(with("v_mm[2]", "4").numbers("v", {3}),
            (std::vector<double>{0.001, 0.004, -0.003}));
  EXPECT_EQ(with("v_mm[3]", "*2").numbers("v", {3}),
            (std::vector<double>{0.001, 0.0025, -0.006}));
  EXPECT_EQ(with("m", "*-0.5").numbers("m", {2, 2}),
            (std::vector<double>{-0.5, -1, -1.5, -2}));
  EXPECT_EQ(with("n", "*1.5").number("n"), 10.5);
  EXPECT_ERROR(with("v_mm[4]", "4"),
               "v_mm[4] = 4 must be a key of the file: TABLE.KEY, "
               "TABLE[NUMBER].KEY or TABLE[NAME].KEY");
  // The factor works in every unit.
  EXPECT_EQ(with("v_m[1]", "*2").numbers("v", {3})[0], 0.002);
  EXPECT_ERROR(with("colour", "*2"),
               "colour = *2: unknown key \"colour\" (v, m, n)");
  EXPECT_ERROR(TomlTable::from_text("w = 1", "t.toml", {{"w"}, {"u"}}, {},
                                    {{"u", "*2"}}),
               "u = *2 requires a number, or numbers, to multiply");
}

// The later of two settings of one key would silently replace the earlier one.
TEST_F(JointFolder, OneKeyIsSetOnce) {
  write("b.toml", "x_mm = 1\n[[c]]\nname = \"d\"\ny = 3\nz = [1, 2]\n");
  const auto inner = +[] {
    return KnownKeys{{"x", Dimension::length},
                     table_key("c", {{"name"}, {"y"}, {"z"}})};
  };
  write("a.toml", "[[t]]\nname = \"one\"\nb = \"b.toml\"\n");
  const auto outer = +[] {
    return KnownKeys{
        table_key("t", {{"name"},
                        {.key = "b",
                         .of_file = {{"x", Dimension::length},
                                     table_key("c", {{"y"}, {"z"}})}}})};
  };
  const auto message = [&](const KeySettings& settings) {
    return error_message([&] {
      TomlTable::from_file(folder_ / "a.toml", outer(), settings)
          .tables("t")[0]
          .file("b", inner);
    });
  };
  const std::pair<KeySettings, const char*> cases[] = {
      {{{"t[1].x_mm", "2"}, {"t[one].c[1].y", "4"}}, "(no error)"},
      {{{"t[1].c[1].z", "*2"}, {"t[1].c[1].z[1]", "4"}}, "(no error)"},
      {{{"t[1].x_mm", "2"}, {"t[one].x_m", "4"}},
       "x_m = 4 conflicts with x_mm"},
      {{{"t[1].c[d].y", "2"}, {"t[one].c[1].y", "4"}},
       "c[1].y = 4 conflicts with c[d].y"},
      {{{"t[1].c[1].z[2]", "2"}, {"t[one].c[d].z[2]", "4"}},
       "c[d].z[2] = 4 conflicts with c[1].z[2]"},
      {{{"t[1].name", "a"}, {"t[1].name", "b"}},
       "t[1].name = b conflicts with t[1].name"}};
  for (const auto& [settings, said] : cases) EXPECT_EQ(message(settings), said);
}

// A file is parsed once: what becomes of it later is not seen.
TEST_F(JointFolder, AreParsedOnceAndReadWithSettings) {
  write("a.toml", "b = \"b.toml\"\n");
  write("b.toml", "x = 1\ny = 2\n");
  const auto inner = +[] { return KnownKeys{{"x"}, {"y"}}; };
  const auto outer = +[] {
    return KnownKeys{{.key = "b", .of_file = {{"x"}, {"y"}}}};
  };
  const TomlFiles files;
  const auto x = [&](const KeySettings& settings) {
    return files.open(folder_ / "a.toml", outer, settings)
        .file("b", inner)
        .number("x");
  };
  EXPECT_EQ(x({}), 1);
  write("b.toml", "x = 5\ny = 2\n");
  EXPECT_EQ(x({}), 1);
  EXPECT_EQ(x({{"x", "3"}}), 3);
  EXPECT_EQ(x({{"x", "*4"}}), 4);
  EXPECT_EQ(x({}), 1);
}

TEST(TomlTable, ArraysMatricesIntegersFlags) {
  const KnownKeys keys = {{"v", Dimension::length},
                          {"m", Dimension::inertia},
                          integer_key("n", 0, 7),
                          {"flag"},
                          word_key("word", {"a", "b"}),
                          table_key("item", {{"x"}, {"y"}}),
                          {"(no error)"}};
  const std::string text =
      "v_mm = [1, 2.5, -3]\n"
      "m_kg_m2 = [[1, 2], [3, 4]]\n"
      "n = 7\nflag = true\nword = \"b\"\n"
      "[[item]]\nx = 1\n[[item]]\nx = 2\n";
  const auto table = TomlTable::from_text(text, "t.toml", keys);
  EXPECT_EQ(table.numbers("v", {3}),
            (std::vector<double>{1e-3, 2.5e-3, -3e-3}));
  EXPECT_EQ(table.numbers("m", {2, 2}), (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(table.numbers("m", {1, 2, true}),
            (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(table.integer("n"), 7);
  EXPECT_TRUE(table.flag("flag"));
  EXPECT_FALSE(table.flag("(no error)"));
  EXPECT_EQ(table.choice("word"), 1u);
  const auto items = table.tables("item");
  ASSERT_EQ(items.size(), 2u);
  EXPECT_EQ(items[1].number("x"), 2);
  EXPECT_TRUE(table.tables("(no error)").empty());
  EXPECT_EQ(items[0].number("x"), 1);
  // The program has not declared it.
  EXPECT_THROW(static_cast<void>(table.has("other")), std::logic_error);

  EXPECT_ERROR(TomlTable::from_text(text, "t.toml",
                                    KnownKeys({{"v", Dimension::length},
                                               {"m", Dimension::inertia},
                                               {"n"},
                                               {"flag"},
                                               {"word"},
                                               table_key("item", {{"y"}})})),
               "t.toml:7: unknown key \"item[1].x\" (y)");
  EXPECT_ERROR(table.numbers("v", {2}),
               "t.toml:1: v_mm = [1, 2.5, -3] must be an array of 2 numbers");
  EXPECT_ERROR(table.numbers("v", {3}, Interval::positive()),
               "t.toml:1: v_mm[3] = -3 must be above 0");
  const std::string matrix =
      "t.toml:2: m_kg_m2 = [[1, 2], [3, 4]] must be an "
      "array of 3 ";
  EXPECT_ERROR(table.numbers("m", {3, 3}), matrix + "arrays of 3 numbers");
  EXPECT_ERROR(table.numbers("m", {3, 2, true}),
               matrix + "or more arrays of 2 numbers");
  EXPECT_ERROR(table.numbers("m", {2, 2}, {0, 3}),
               "t.toml:2: m_kg_m2[2][2] = 4 must be 0 to 3 kg m^2");
  const std::string n = "t.toml:3: n = 7 must be ";
  KnownKeys with_few = keys;
  with_few[2] = integer_key("n", 0, 6);
  with_few[3] = integer_key("flag", 0, 6);
  const auto few = TomlTable::from_text(text, "t.toml", with_few);
  EXPECT_ERROR(few.integer("n"), n + "an integer, 0 to 6");
  EXPECT_ERROR(table.flag("n"), n + "true or false");
  EXPECT_ERROR(table.tables("n"), n + "an array of tables");
  EXPECT_ERROR(table.table("n"), n + "a table");
  EXPECT_ERROR(few.integer("flag"),
               "t.toml:4: flag = true must be an integer, 0 to 6");
  EXPECT_ERROR(items[1].fail("x", "too many"),
               "t.toml:9: item[2].x = 2: too many");
  EXPECT_ERROR(items[1].fail("y", "no y"), "t.toml:8: item[2].y: no y");
}

// A number that is read from a text.
double number_of(const std::string& value, const Interval& range) {
  return TomlTable::from_text("x = " + value, "t", {{"x"}}).number("x", range);
}

TEST(TomlTable, ValuesInMessagesStayShort) {
  const auto shown = [](const std::string& value) {
    const std::string message =
        error_message([&] { number_of(value, Interval::any()); });
    return message.substr(9, message.find(" must be") - 9);
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
  EXPECT_ERROR(TomlTable::from_text("x = [[1, 2], [3, true]]", "t", {{"x"}})
                   .numbers("x", {1, 2, true}, Interval::any()),
               "t:1: x[2][2] = true must be a number");
}

TEST(TomlTable, RangesReadAsSentences) {
  for (const auto& [given, rule] :
       {std::pair{Interval::any(), "a finite number"},
        {Interval::positive(), "above 0"},
        {Interval::non_negative(), "0 or above"},
        {{1, 2}, "1 to 2"},
        {{1, 2, true, true}, "above 1 and below 2"},
        {{1, 2, true, false}, "above 1 and up to 2"},
        {{1, 2, false, true}, "from 1 and below 2"},
        {{-Interval::largest, 2}, "up to 2"},
        {{-Interval::largest, 2, false, true}, "below 2"}}) {
    const Interval range = given;  // which clang 14 captures
    EXPECT_ERROR(number_of("nan", range),
                 std::string("t:1: x = nan must be ") + rule);
  }
}

TEST(TomlTable, TextWithoutANameHasMessagesWithoutAPlace) {
  const std::string cube = "kind = 'cube'\nname = 'x'\n[geometry]";
  for (const KeySettings& settings : {KeySettings{}, {{"kind", "\"cube\""}}}) {
    EXPECT_ERROR(parse_joint(cube, "", settings),
                 "kind = \"cube\" must be \"ball\" or \"pin\"");
  }
}

TEST(TomlTable, IsWrittenAsItReads) {
  const auto read = [](const std::string& text) {
    return TomlTable::from_text(text, "x",
                                {{"a"}, table_key("t", {{"b"}, {"c"}})}, {},
                                {{"t.c", "[0.1, inf, 1e300]"}});
  };
  const TomlTable table = read("# why\na = 'x\"\\y'\n[t]\nb = true\n");
  EXPECT_EQ(read(table.toml_text()).canonical_text(), table.canonical_text());
}

// `count` parts with dots between.
std::string dotted(const std::string& part, int count) {
  std::string key = part;
  for (int i = 1; i < count; ++i) key += '.' + part;
  return key;
}

std::string complaint(const std::string& text,
                      const KeySettings& settings = {}) {
  return error_message(
      [&] { TomlTable::from_text(text, "t.toml", {{"a"}}, {}, settings); });
}

// Each part is a table inside the one before it: 400,000 overflow the stack.
TEST(TomlTable, KeysOfTooManyPartsAreRefused) {
  const std::string refused = "t.toml:3: a key must be of at most 32 parts";
  for (const int parts : {33, 400'000}) {
    for (const std::string part : {"a", " 'b=,]'\t", R"("\"=")"}) {
      const std::string key = dotted(part, parts);
      EXPECT_EQ(complaint("\n\n" + key + " = 1"), refused);
      EXPECT_EQ(complaint("\n\n[" + key + ']'), refused);
      EXPECT_EQ(complaint("\n\n[[" + key + "]]"), refused);
      EXPECT_EQ(complaint("a = [1.5,\n{ b = '.' },\n{ " + key + " = 1 }]"),
                refused);
      EXPECT_EQ(complaint("a = \"\"\"\n\"\"\"\"\"\n" + key + " = 1"), refused);
    }
    EXPECT_TRUE(
        has_text(complaint("", {{dotted("a", parts), "1"}}), "must be a key"));
    EXPECT_EQ(complaint("", {{"a", "{ " + dotted("b", parts) + " = 1 }"}}),
              "(no error)");
  }
  // Tables that are nested in values.
  std::string deep = "1";
  for (int i = 0; i < 100; ++i) deep = "{ b = " + deep + " }";
  EXPECT_TRUE(complaint("a = " + deep).starts_with("t.toml:1: "));
}

TEST(TomlTable, DotsElsewhereAreNoPartsOfKeys) {
  EXPECT_EQ(complaint(dotted("a", 32) + " = 1"), "(no error)");
  const std::string dots = dotted("x", 100);
  std::string numbers = "1.5";
  for (int i = 0; i < 100; ++i) numbers += ", 1.5";
  for (const std::string& text :
       {'"' + dots + '"', '\'' + dots + '\'', "\"\"\"\n" + dots + "\"\"\"\"",
        "'''\n''" + dots + "'''", "1 # " + dots, '[' + numbers + ']'}) {
    EXPECT_EQ(complaint("a = " + text), "(no error)") << text;
  }
}

TEST(TomlTable, OutlivesItsParent) {
  const TomlTable inner = [] {
    return TomlTable::from_text("[a]\nx = 1", "t", {table_key("a", {{"x"}})})
        .table("a");
  }();
  EXPECT_EQ(inner.number("x"), 1);
  EXPECT_EQ(inner.source(), "t");
}

// Options of programs are settings that say where they are from.
TEST(JointFile, MessagesNameTheOriginOfSettings) {
  const std::string file = EditedFile("ball.toml").text();
  const auto said = [&](const contact::KeySettings& settings) {
    return contact::test::error_message(
        [&] { parse_joint(file, "j.toml", settings); });
  };
  const contact::KeySetting diameter{"geometry.diameter_mm", "40",
                                     "--diameter 40mm"};
  EXPECT_EQ(said({{"geometry.radius_mm", "-50", "--radius -50mm"}}),
            "--radius -50mm must be above 0");
  EXPECT_EQ(said({diameter}).find("--diameter 40mm conflicts with geometry."),
            0U);
  EXPECT_EQ(said({{"geometry.radius_m", "1", "--radius 1"}, diameter}),
            "--diameter 40mm conflicts with --radius 1");
  EXPECT_EQ(said({{"geometry.radius_mm", "-50"}}),
            "j.toml with geometry.radius_mm = -50: geometry.radius_mm = -50 "
            "must be above 0");
  EXPECT_EQ(said({{"geometry.length_mm", "3", "--length 3mm"}}),
            "--length 3mm: geometry.length_mm = 3 must be left out: it has no "
            "effect here");
}

TEST(JointFile, ContactIsMadeOfAllThatTheFileSays) {
  const JointSpec joint = sample_joint("hip_cocr_uhmwpe_infinite");
  const JointContact one = joint.contact();
  EXPECT_EQ(one.geometry().radius(), joint.geometry.radius());
  EXPECT_EQ(one.pair(), joint.pair());
  EXPECT_EQ(dry(one.friction()).coefficient(),
            dry(joint.friction).coefficient());
  EXPECT_EQ(one.half_angle_law().name(), joint.make_half_angle_law()->name());
  EXPECT_EQ(one.pressure_law().name(), joint.make_pressure_law()->name());
  SharedLaws laws;
  EXPECT_EQ(&joint.contact(laws).half_angle_law(),
            laws.half_angle(joint).get());
  JointSpec frictionless = joint;
  frictionless.name = "hip";
  frictionless.friction.reset();
  EXPECT_ERROR(frictionless.contact(),
               "joint \"hip\" requires [friction], of the joint or of its "
               "materials");
}

TEST(SharedLaws, AreThoseOfJointsThatAreAlike) {
  SharedLaws laws;
  const auto half_angle = [&](const JointSpec& joint) {
    return laws.half_angle(joint).get();
  };
  const auto pressure = [&](const JointSpec& joint) {
    return laws.pressure(joint).get();
  };
  const JointSpec joint = sample_joint("wheel_ball");
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
  third.pressure_law = "cosine";
  EXPECT_NE(pressure(third), pressure(joint));
  for (const char* name :
       {"wheel_pin", "hip_cocr_uhmwpe_infinite", "hip_cocr_uhmwpe"}) {
    const JointSpec unlike = sample_joint(name);
    EXPECT_NE(half_angle(unlike), half_angle(joint)) << name;
    EXPECT_NE(pressure(unlike), pressure(joint)) << name;
  }
}

// A liner without a wall gives a warning for any law; a wall, or liner = false,
// removes it. The note belongs to the contact, so that all interfaces have it.
TEST(JointFile, LinersWithoutAWall) {
  const auto notes = [](const JointSpec& joint) {
    return joint.contact().limits().notes({.half_angle = 0.1});
  };
  const std::string bush =
      "name = 'bush'\nkind = 'pin'\ngeometry = { radius_mm = 10, "
      "radial_clearance_um = 20, length_mm = 20 }\n[materials]\npair = '" +
      std::string(CONTACT_DATA_DIR) + "/materials/steel_ptfe_liner.toml'\n";
  for (const char* law : {"", "[half_angle]\nlaw = 'exact'\n"}) {
    const JointSpec joint = parse_joint(bush + law, "bush.toml");
    EXPECT_TRUE(joint.pair().outer().liner);
    const auto said = notes(joint);
    ASSERT_EQ(said.size(), 1u);
    EXPECT_TRUE(said[0].starts_with(
        "the outer body, woven PTFE liner, is a liner, but modelled as "
        "unbounded: "));
    EXPECT_EQ(joint.contact().limits().passed({.half_angle = 0.1}), said);
    EXPECT_TRUE(joint.contact().limits().notes({}).empty());
    // The text of the joint is the joint.
    EXPECT_EQ(parse_joint(joint.canonical_text(), ""), joint);
    const JointSpec meant =
        parse_joint(bush + "liner = false\n" + law, "bush.toml");
    EXPECT_TRUE(notes(meant).empty());
  }
  const std::string wall =
      "[[wall.layer]]\nthickness_mm = 0.3\n[wall.backing]\n"
      "youngs_modulus_GPa = 207\npoissons_ratio = 0.292\n";
  EXPECT_TRUE(notes(parse_joint(bush + wall, "bush.toml")).empty());
  // Behind a wall it has no end either.
  EXPECT_EQ(notes(parse_joint(bush + wall + "liner = true\n", "b.toml")).size(),
            1u);
  for (const char* name : {"hip_cocr_uhmwpe", "hip_cocr_uhmwpe_infinite",
                           "spherical_plain_bearing_infinite", "hip_cup"}) {
    EXPECT_TRUE(notes(sample_joint(name)).empty()) << name;
  }
}

TEST(JointFile, NamesAShippedPair) {
  namespace fs = std::filesystem;
  const auto with_pair = [](const std::string& pair, const fs::path& folder) {
    return parse_joint(
        "kind = 'ball'\n[geometry]\nradius_mm = 20\nradial_clearance_um = 30\n"
        "[materials]\npair = '" +
            pair + "'\n",
        "j.toml", {}, folder);
  };
  const JointSpec by_path =
      with_pair("materials/steel_bronze.toml", CONTACT_DATA_DIR);
  EXPECT_ERROR(with_pair("steel_bronze", ""),
               "j.toml:6: materials.pair = \"steel_bronze\": steel_bronze: "
               "cannot be read: No such file or directory");
  detail::shipped_data() = CONTACT_DATA_DIR;
  EXPECT_EQ(with_pair("steel_bronze", ""), by_path);
  EXPECT_NE(error_message([&] { with_pair("pin_joint", ""); }), "(no error)");
  // A file of its folder comes first.
  const ProgramFolder folder;
  fs::copy_file(CONTACT_DATA_DIR "/materials/steel_steel.toml",
                folder.path() / "steel_bronze");
  EXPECT_EQ(with_pair("steel_bronze", folder.path()),
            with_pair("steel_steel", ""));
  detail::shipped_data().clear();
}

TEST(JointFile, OtherEncodings) {
  for (const char* text : {"\xFF\xFEn", "# M\xFCller\n"}) {
    EXPECT_ERROR(
        parse_joint(text, "j.toml"),
        "j.toml:1: the file must be UTF-8: it is UTF-16, Latin-1 or no "
        "text");
  }
}

// The name of its file, without the ending.
TEST(JointFile, NameOfAJointWithoutOne) {
  EditedFile file("ball.toml");
  const std::string text = file.text();
  const std::string unnamed = text.substr(text.find('\n') + 1);
  EXPECT_EQ(parse_joint(unnamed, "joints/left door.toml").name, "left door");
  EXPECT_EQ(parse_joint(text, "joints/left door.toml").name, "test joint");
  EXPECT_ERROR(parse_joint(unnamed, ""), "the file requires name");
}

}  // namespace
}  // namespace contact::test::joint_file_test
