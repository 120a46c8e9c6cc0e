// Case files: the meaning of valid ones. For messages see tests/messages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/files/toml_reader.hpp"
#include "separation/case/case_reader.hpp"
#include "separation/case/force_law.hpp"
#include "separation/case/system_of.hpp"
#include "support/edited_file.hpp"
#include "support/error_message.hpp"
#include "support/toml_text.hpp"

namespace contact::test::case_file_test {
namespace {

namespace fs = std::filesystem;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using multibody::HingeKind;
using separation::Case;
using separation::Event;
using separation::parse_case;

EditedFile case_file() { return EditedFile("case.toml"); }

Case parsed(const EditedFile& file, const separation::JointLaws& laws = {}) {
  return parse_case(file.text(), "c.toml", laws);
}

TEST(CaseFile, ReadsEverything) {
  const Case c = parsed(case_file());
  EXPECT_EQ(c.name, "test");
  EXPECT_EQ(c.end_time, 2);
  EXPECT_EQ(c.output_step, 0.01);
  EXPECT_EQ(c.options.gravity, Vector3d(0, 0, -9.81));
  EXPECT_EQ(c.carrier.mass, 1000);
  ASSERT_EQ(c.bodies.size(), 2U);
  const separation::Body& body = c.bodies[1];
  EXPECT_EQ(body.rigid.name, "arm 2");
  EXPECT_EQ(body.group, "arm");
  // A cylinder of water; its middle is the centre of mass.
  EXPECT_NEAR(body.rigid.mass, 1000 * std::numbers::pi * 0.01 * 2, 1e-12);
  EXPECT_LE((body.rigid.com - Vector3d(1, 0, 0)).norm(), 1e-15);
  EXPECT_NEAR(body.rigid.inertia(0, 0), body.rigid.mass * 0.01 / 2, 1e-12);
  EXPECT_LE((body.rigid.shapes[0].from - Vector3d(-1, 0, 0)).norm(), 1e-15);
  EXPECT_EQ(body.hinge.kind, HingeKind::axis);
  EXPECT_LE((body.hinge.body_point - Vector3d(-1, 0, 0)).norm(), 1e-15);
  // The second copy is turned by 180 deg about x.
  EXPECT_LE((body.hinge.parent_point - Vector3d(2, -0.5, 0)).norm(), 1e-15);
  EXPECT_LE((body.hinge.axis - Vector3d(0, 0, -1)).norm(), 1e-15);
  EXPECT_TRUE(body.start.locked);
  EXPECT_EQ(body.hinge.joints.size(), 1U);
  ASSERT_EQ(c.events.size(), 2U);
  EXPECT_EQ(c.events[0].bodies, (std::vector<int>{0, 1}));
  EXPECT_EQ(c.events[0].trigger, Event::Trigger::time);
  EXPECT_EQ(c.events[1].bodies, std::vector<int>{1});
  EXPECT_EQ(c.events[1].after, 0);
  EXPECT_NEAR(c.events[1].value, 30 * degree, 1e-15);
  ASSERT_EQ(c.forces.size(), 2U);
  EXPECT_EQ(c.forces[1].body, 2);
  EXPECT_EQ(c.forces[1].law->own_clock().event, 0);
  // The carrier has no shape.
  ASSERT_EQ(c.clearance.size(), 1U);
  EXPECT_EQ(c.clearance[0].a, 1);
  EXPECT_EQ(c.clearance[0].b, 2);
}

// The origins of body and carrier, where points are left out.
TEST(CaseFile, PointsOfAHingeDefaultAlike) {
  const auto hinge = [](const char* points) {
    const Case c = parsed(case_file().edit("24", points));
    return std::pair(c.bodies[0].hinge.body_point,
                     c.bodies[0].hinge.parent_point);
  };
  const auto left_out = hinge("");
  EXPECT_EQ(left_out.first, Vector3d(-1, 0, 0));  // from the centre of mass
  EXPECT_EQ(left_out.second, Vector3d(-1, 0, 0));
  EXPECT_EQ(hinge("body_point_m = [0, 0, 0]\ncarrier_point_m = [0, 0, 0]"),
            left_out);
}

TEST(CaseFile, AnglesOfTheAxisComeBack) {
  const Case c = parsed(case_file());
  const separation::Hinge& hinge = c.bodies[1].hinge;
  for (const double angle : {-3.0, -0.5, 0.0, 1e-9, 2.0, 3.1}) {
    const Matrix3d rotation =
        Eigen::AngleAxisd(angle, hinge.axis).toRotationMatrix() *
        hinge.zero_rotation;
    EXPECT_NEAR(separation::hinge_angle(hinge, rotation), angle, 1e-15);
  }
}

// The copies of a body against each other.
TEST(CaseFile, DistancesOfCopies) {
  const Case c =
      parsed(case_file().edit("+", "[[clearance]]\na = \"arm\"\nb = \"arm\""));
  EXPECT_EQ(c.clearance.size(), 1U);
}

TEST(CaseFile, ForcesAreAddedUp) {
  const std::string engine =
      "[[force]]\nname = \"engine 2\"\nbody = \"arm\"\nkind = \"thrust\"\n"
      "point_m = [0, 0, 0]\ndirection = [1, 0, 0]\nthrust_kN = 2";
  EXPECT_EQ(parsed(case_file().edit("+", engine)).forces.size(), 4U);
}

// Content is the same however it is written.
TEST(CaseFile, ContentIsThatOfTheText) {
  const auto content = [](const std::string& text) {
    return TomlTable::from_text(text, "t.toml",
                                {{"a"}, {"b"}, {"c"}, {"t"}, {"u"}})
        .canonical_text();
  };
  const std::string text = content(
      "a = 1\nb = \"x\"\n[t]\nc = [1, 2.5]\nd = { e = true }\n"
      "[[u]]\n[[u]]\nf = 1979-05-27\n");
  EXPECT_EQ(text, content("# first\nb   = 'x' # b\na = 1.0\n\n[[u]]\n[[u]]\n"
                          "f = 1979-05-27\n\n[t.d]\ne = true\n"
                          "[t]\nc = [ 0x1,\n 25e-1, ] \n"));
  for (const char* other :
       {"a = 2\nb = \"x\"\n[t]\nc = [1, 2.5]\nd = { e = true }\n"
        "[[u]]\n[[u]]\nf = 1979-05-27\n",
        "a = 1\nb = \"y\"\n[t]\nc = [1, 2.5]\nd = { e = true }\n"
        "[[u]]\n[[u]]\nf = 1979-05-27\n",
        "a = 1\nb = \"x\"\n[t]\nc = [2.5, 1]\nd = { e = true }\n"
        "[[u]]\n[[u]]\nf = 1979-05-27\n",
        "a = 1\nb = \"x\"\n[t]\nc = [1, 2.5]\nd = { e = false }\n"
        "[[u]]\n[[u]]\nf = 1979-05-27\n",
        "a = 1\nb = \"x\"\n[t]\nc = [1, 2.5]\nd = { e = true }\n"
        "[[u]]\nf = 1979-05-27\n[[u]]\n"}) {
    EXPECT_NE(text, content(other)) << other;
  }
  // Texts end where they end, and long lists are whole.
  EXPECT_NE(content("a = \"b,1:c=\\\"1:d\""), content("a = \"b\"\nc = \"d\""));
  std::string list = "a = [0";
  for (int i = 1; i < 200; ++i) list += ", " + std::to_string(i);
  EXPECT_NE(content(list + ", 200]"), content(list + ", 201]"));
}

TEST(CaseFile, JointsOfAFileHaveNamesOfTheirOwn) {
  const Case c =
      parsed(case_file().edit("28", "name = \"left pin\"\n[body.lock]"));
  EXPECT_EQ(c.bodies[0].hinge.joints[0].joint.name, "left pin");
}

std::vector<const JointContact*> contacts(const Case& c) {
  std::vector<const JointContact*> all;
  for (const separation::Body& body : c.bodies) {
    for (const auto& joint : body.hinge.joints) all.push_back(&joint.contact());
  }
  return all;
}

TEST(CaseFile, JointsThatAreAlikeShareTheirLaws) {
  const fs::path cases = fs::path(CONTACT_DATA_DIR) / "cases";
  const Case arms = separation::read_case(cases / "platform.toml");
  // A second body, whose joint names the same file.
  const Case one_file = parsed(
      case_file().edit(
          "30",
          R"([[body]]; name = "leg"; mass_kg = 1; principal_inertia_kg_m2 = [1, 1, 1]
[body.hinge]; kind = "axis"; carrier_point_m = [3, 0.5, 0]; axis = [0, 0, 2]
[[body.hinge.joint]]; file = "@DATA@/joints/pin_joint.toml"
[body.lock]; body_point_m = [2, 0, 0]
[[event]])"_toml),
      {"exact", "exact"});
  ASSERT_EQ(contacts(arms).size(), 6U);
  ASSERT_EQ(contacts(one_file).size(), 3U);
  for (const Case* c : {&arms, &one_file}) {
    const auto all = contacts(*c);
    for (const JointContact* other : all) {
      EXPECT_EQ(&other->half_angle_law(), &all[0]->half_angle_law());
      EXPECT_EQ(&other->pressure_law(), &all[0]->pressure_law());
    }
  }
}

TEST(CaseFile, LawsOfTheCommandLineAreTaken) {
  const Case c = parsed(case_file(), {"tanh", ""});
  EXPECT_EQ(c.bodies[0].hinge.joints[0].joint.half_angle_law, "tanh");
  const auto message = [](const separation::JointLaws& laws) {
    return error_message([&] { parsed(case_file(), laws); });
  };
  const std::string joint =
      ": joint \"pin joint, 40 mm steel pin in bronze\": ";
  EXPECT_EQ(message({"blend:x", ""}),
            "--law blend:x" + joint +
                "half-angle law blend:x must be blend:K with K a number from 0 "
                "to 1");
  EXPECT_EQ(message({"", "cosin"}),
            "--pressure cosin" + joint +
                "unknown pressure law \"cosin\": did you mean \"cosine\"? "
                "(cosine, sqrt_tan, sqrt_theta, mixture, exact, worn)");
}

// Settings of the case, of a file that it names, and of one named by that.
TEST(CaseFile, SettingsReachTheFilesOfItsJoints) {
  const fs::path file = CONTACT_DATA_DIR "/cases/flywheels.toml";
  const Case plain = separation::read_case(file);
  const std::string& name = plain.bodies[1].rigid.name;
  const std::string joint = "body[2].hinge.joint[1].";
  const Case changed = separation::read_case(
      file, {},
      {{"body[" + name + "].mass_kg", "3"},
       {joint + "position_mm", "-20"},
       {joint + "geometry.radial_clearance_um", "80"},
       {joint + "materials.outer.youngs_modulus_GPa", "50"},
       {joint + "friction.coefficient", "0.25"}});
  EXPECT_EQ(changed.bodies[1].rigid.mass, 3);
  const auto& was = plain.bodies[1].hinge.joints[0];
  const auto& is = changed.bodies[1].hinge.joints[0];
  EXPECT_EQ(is.position, -0.02);
  EXPECT_DOUBLE_EQ(is.joint.geometry.radial_clearance(), 80e-6);
  EXPECT_EQ(is.joint.geometry.radius(), was.joint.geometry.radius());
  EXPECT_NE(is.joint.pair().contact_modulus(),
            was.joint.pair().contact_modulus());
  EXPECT_EQ(std::get<FrictionLaw>(*is.joint.friction).coefficient(), 0.25);
  EXPECT_EQ(changed.bodies[0].hinge.joints[0].joint.pair(), was.joint.pair());
}

TEST(CaseFile, SettingsThatAreWrongAreNamed) {
  const auto message = [](const std::string& key, const std::string& value) {
    try {
      separation::read_case(CONTACT_DATA_DIR "/cases/flywheels.toml", {},
                            {{key, value}});
    } catch (const Error& error) {
      std::string text = error.what();
      for (const std::string folder = CONTACT_DATA_DIR "/";
           text.find(folder) != text.npos;) {
        text.erase(text.find(folder), folder.size());
      }
      return text;
    }
    return std::string();
  };
  EXPECT_EQ(
      message("body[rotor].mass_kg", "1"),
      "body[rotor].mass_kg = 1: unknown body \"rotor\" (wheel x, wheel y, "
      "wheel z)");
  EXPECT_EQ(message("body[wheel w].mass_kg", "1"),
            "body[wheel w].mass_kg = 1: unknown body \"wheel w\": did you mean "
            "\"wheel x\"? (wheel x, wheel y, wheel z)");
  EXPECT_EQ(message("body[9].mass_kg", "1"),
            "body[9].mass_kg = 1 must be a key of the file: TABLE.KEY, "
            "TABLE[NUMBER].KEY or TABLE[NAME].KEY");
  EXPECT_EQ(message("body.mass_kg", "1"),
            "body.mass_kg = 1 must be of one body, as body[wheel x]");
  EXPECT_THAT(
      message("body[wheel x].hinges[1].axis", "1"),
      testing::StartsWith("body[wheel x].hinges[1].axis = 1: unknown key "
                          "\"body[1].hinges\": did you mean \"hinge\"?"));
  EXPECT_THAT(message("body[1].mas_kg", "*2"),
              testing::StartsWith("body[1].mas_kg = *2: unknown key "
                                  "\"body[1].mas_kg\": did you mean "
                                  "\"mass"));
  const std::string joint = "body[1].hinge.joint[1].";
  const std::string in_case =
      "cases/flywheels.toml:44: body[1].hinge.joint[1].file = "
      "\"../joints/wheel_ball.toml\": cases/../joints/wheel_ball.toml";
  EXPECT_EQ(message(joint + "geometry.radius_mm", "-1"),
            in_case +
                " with geometry.radius_mm = -1: geometry.radius_mm = -1 "
                "must be above 0");
  EXPECT_THAT(message(joint + "geometry.colour", "red"),
              testing::StartsWith(in_case + " with geometry.colour = red: "
                                            "unknown key \"geometry.colour\""));
  EXPECT_THAT(message(joint + "colour", "red"),
              testing::StartsWith("cases/flywheels.toml with "
                                  "body[1].hinge.joint[1].colour = red: "
                                  "unknown key"));
}

TEST(CaseFile, AllCasesOfTheProjectAreGood) {
  int count = 0;
  for (const auto& file :
       fs::directory_iterator(fs::path(CONTACT_DATA_DIR) / "cases")) {
    EXPECT_NO_THROW(separation::read_case(file.path())) << file.path();
    ++count;
  }
  EXPECT_GE(count, 5);
}

}  // namespace
}  // namespace contact::test::case_file_test
