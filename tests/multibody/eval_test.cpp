// Cases of single instants: the one message that every bad one gives.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "multibody_oracle/case_file.hpp"
#include "multibody_oracle/json_text.hpp"
#include "support/error_message.hpp"
#include "support/program.hpp"

namespace {

using contact::test::error_message;
using contact::test::ProgramFolder;
using contact::test::ProgramResult;
using multibody::instant_from_json;
using nlohmann::json;

// A load of each kind, everything in it.
json good() {
  const json unit = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const json zero = {0, 0, 0};
  json axis = {{"kind", "axis"},
               {"mass", 1},
               {"inertia_com", unit},
               {"hinge_from_com", zero},
               {"hinge_from_carrier_com", {1, 0, 0}},
               {"hinge_to_load", unit},
               {"hinge_to_carrier_zero", unit},
               {"angle", 0},
               {"angle_rate", 0},
               {"rotation_to_carrier", unit},
               {"relative_angular_velocity", zero},
               {"angular_velocity", zero},
               {"held", false},
               {"active_force", {1, 2, 3}},
               {"active_moment_com", {1, 2, 3}},
               {"friction_moment", {0, 0, 1}}};
  json ball = axis;
  ball["kind"] = "spherical";
  for (const char* key :
       {"hinge_to_load", "hinge_to_carrier_zero", "angle", "angle_rate"}) {
    ball.erase(key);
  }
  json free = ball;
  free["kind"] = "free";
  for (const char* key : {"hinge_from_com", "hinge_from_carrier_com", "held",
                          "friction_moment"}) {
    free.erase(key);
  }
  return {{"schema", "carrier-loads/1"},
          {"kind", "mixed"},
          {"name", "all"},
          {"seed", 1},
          {"oracle", "none"},
          {"expected", {{"whatever", 1}}},
          {"gravity_inertial", {0, 0, -9.81}},
          {"carrier",
           {{"mass", 1},
            {"inertia_com", unit},
            {"rotation_to_inertial", unit},
            {"position_com", zero},
            {"velocity_com", zero},
            {"angular_velocity", zero},
            {"active_force", {1, 2, 3}},
            {"active_moment_com", {1, 2, 3}}}},
          {"loads", {axis, ball, free}}};
}

std::string message(const json& file) {
  return error_message([&] { instant_from_json(file); });
}

// That of the good case with the key at `place` called otherwise.
std::string message_renamed(const std::string& place, const char* from,
                            const char* to) {
  json file = good();
  json& object = file[json::json_pointer(place)];
  object[to] = object.at(from);
  object.erase(from);
  return message(file);
}

TEST(MultibodyEval, EveryMisspeltKeyIsRefused) {
  ASSERT_EQ(message(good()), "(no error)");
  EXPECT_EQ(message_renamed("", "gravity_inertial", "gravity_inertail"),
            "gravity_inertail: unknown key of the file: did you mean "
            "gravity_inertial?");
  EXPECT_EQ(message_renamed("", "gravity_inertial", "gravity"),
            "gravity: unknown key of the file: allowed: schema, name, kind, "
            "seed, oracle, gravity_inertial, carrier, loads, expected");
  EXPECT_EQ(message_renamed("/loads/1", "friction_moment", "frction_moment"),
            "loads[1].frction_moment: unknown key of a load on a ball joint: "
            "did you mean friction_moment?");
  // Not one of them is passed over.
  for (const std::string place :
       {"", "/carrier", "/loads/0", "/loads/1", "/loads/2"}) {
    const json file = good();
    for (const auto& [key, value] : file[json::json_pointer(place)].items()) {
      // What tells the kind of the object is asked for first.
      if (key == "schema" || key == "kind") continue;
      json misspelt = file;
      json& object = misspelt[json::json_pointer(place)];
      object.erase(key);
      object[key + "s"] = value;
      EXPECT_NE(message(misspelt).find(key + "s: unknown key of"),
                std::string::npos)
          << place << ' ' << key << ": " << message(misspelt);
    }
  }
}

TEST(MultibodyEval, RefusesWithTheFilesNameAndNoResult) {
  json file = good();
  const ProgramFolder folder;
  folder.write("c.json", file.dump());
  EXPECT_EQ(folder.run("multibody-eval c.json").status, 0);
  file["carrier"]["active_forces"] = {1, 2, 3};
  folder.write("c.json", file.dump());
  const ProgramResult result =
      folder.run("multibody-eval c.json --output o.json");
  EXPECT_EQ(result.status, 2);
  EXPECT_FALSE(folder.has("o.json"));
  EXPECT_EQ(result.err,
            "multibody-eval: c.json: carrier.active_forces: unknown key of the "
            "carrier: allowed: mass, inertia_com, rotation_to_inertial, "
            "position_com, velocity_com, angular_velocity, active_force, "
            "active_moment_com\n");
}

TEST(MultibodyEval, KeysOfOtherKindsAreRefused) {
  json file = good();
  file["loads"][2]["friction_moment"] = {0, 0, 1};
  EXPECT_EQ(message(file),
            "loads[2].friction_moment: unknown key of a free load: allowed: "
            "kind, mass, inertia_com, rotation_to_carrier, "
            "relative_angular_velocity, angular_velocity, active_force, "
            "active_moment_com");
  file = good();
  file["loads"][1]["angle"] = 0;
  EXPECT_NE(message(file).find(
                "loads[1].angle: unknown key of a load on a ball joint"),
            std::string::npos);
  file = good();
  file["kind"] = "axes";
  EXPECT_EQ(message(file),
            "loads[1].kind: \"spherical\", allowed is axis, the file's kind");
  file = good();
  file["loads"][0]["held"] = true;
  EXPECT_EQ(message(file),
            "loads[0].friction_moment: [0,0,1], allowed is 0, since the joint "
            "is held");
}

TEST(MultibodyEval, KeysThatMayBeLeftOut) {
  for (const char* key :
       {"/name", "/seed", "/oracle", "/expected", "/carrier/position_com",
        "/carrier/velocity_com", "/carrier/active_force",
        "/carrier/active_moment_com", "/loads/0/held", "/loads/0/active_force",
        "/loads/0/active_moment_com", "/loads/0/friction_moment",
        "/loads/0/angular_velocity", "/loads/0/rotation_to_carrier",
        "/loads/0/relative_angular_velocity", "/loads/2/active_force"}) {
    const json change = {{{"op", "remove"}, {"path", key}}};
    EXPECT_EQ(message(good().patch(change)), "(no error)") << key;
  }
  for (const char* key :
       {"gravity_inertial", "carrier", "loads", "schema", "kind"}) {
    json file = good();
    file.erase(key);
    EXPECT_EQ(message(file), std::string(key) + ": missing");
  }
  for (const char* key :
       {"mass", "inertia_com", "rotation_to_inertial", "angular_velocity"}) {
    json file = good();
    file["carrier"].erase(key);
    EXPECT_EQ(message(file), std::string("carrier.") + key + ": missing");
  }
}

TEST(MultibodyEval, BadJsonHasItsPlace) {
  const auto parse = [](const std::string& text) {
    return error_message([&] { multibody::parse_json(text, "c.json"); });
  };
  EXPECT_EQ(parse("{\"a\": [1, -2.5e3, true, null, \"x\", {}]}"), "(no error)");
  EXPECT_EQ(parse("{\n  \"a\": [1, {\"b\": 1e400}]}"),
            "c.json:2:18: a[1].b: 1e400, allowed is a finite number");
  EXPECT_EQ(parse("1e400"), "c.json:1:1: 1e400, allowed is a finite number");
  EXPECT_EQ(parse("{\n\"a\": 1\n\"b\": 2}"),
            "c.json:3:3: not JSON: unexpected \"b\"");
  EXPECT_EQ(parse("{\"a\": ["), "c.json:1:8: not JSON: ends in the middle");
  EXPECT_EQ(parse("{\"a\": 1, \"b\": {\"c\": 1, \"c\": 2}}"),
            "c.json: b.c: there twice, allowed is once");
  EXPECT_EQ(parse(std::string(64, '[') + std::string(64, ']')), "(no error)");
  EXPECT_NE(parse(std::string(100'000, '['))
                .find(": nested deeper than 64, which is allowed"),
            std::string::npos);
}

TEST(MultibodyEval, InertiaIsJudgedBesideTheLargest) {
  json file = good();
  file["carrier"]["inertia_com"] = {{1e20, 0, 0}, {0, 10, 0}, {0, 0, 10}};
  ProgramFolder folder;
  folder.write("c.json", file.dump());
  EXPECT_EQ(folder.run("multibody-eval c.json").err,
            "multibody-eval: c.json: carrier.inertia_com: smallest principal "
            "moment = 10 kg m^2 must be above 1000000 kg m^2, the rounding "
            "of the largest moment\n");
}

TEST(MultibodyEval, FilesThatCannotBeRead) {
  const ProgramFolder folder;
  const auto refused = [&](const std::string& file,
                           const std::string& expected) {
    const ProgramResult result = folder.run("multibody-eval " + file);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "multibody-eval: " + file + ": " + expected + '\n');
  };
  folder.write("empty.json", "");
  refused("empty.json", "empty");
  refused("none.json", "cannot be read: No such file or directory");
  refused("data", "cannot be read: a directory");
  refused("/dev/zero", "cannot be read: not a file");
}

}  // namespace
