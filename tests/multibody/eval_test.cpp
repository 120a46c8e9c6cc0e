// Cases of single instants: the one message that every bad one gives.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "multibody_oracle/case_file.hpp"
#include "support/program.hpp"

namespace contact::test::eval_test {
namespace {

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
  try {
    instant_from_json(file);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "(no error)";
}

TEST(MultibodyEval, EveryMisspeltKeyIsRefused) {
  ASSERT_EQ(message(good()), "(no error)");
  for (const std::string place :
       {"", "/carrier", "/loads/0", "/loads/1", "/loads/2"}) {
    const json file = good();
    for (const auto& [key, value] : file[json::json_pointer(place)].items()) {
      // The kind of the body is checked first.
      if (key == "kind" && place != "") continue;
      json misspelt = file;
      json& object = misspelt[json::json_pointer(place)];
      object.erase(key);
      object[key + "s"] = value;
      EXPECT_NE(message(misspelt).find("unknown key \"" + key + "s\" ("),
                std::string::npos)
          << place << ' ' << key << ": " << message(misspelt);
    }
  }
}

TEST(MultibodyEval, RefusesWithTheFilesNameAndNoResult) {
  json file = good();
  const ProgramFolder folder;
  folder.write("c.json", file.dump());
  folder.run_well("multibody-eval c.json");
  file["carrier"]["active_forces"] = {1, 2, 3};
  folder.write("c.json", file.dump());
  const ProgramResult result =
      folder.run("multibody-eval c.json --output o.json");
  EXPECT_EQ(result.status, 2);
  EXPECT_FALSE(folder.has("o.json"));
  EXPECT_EQ(result.err,
            "multibody-eval: c.json: carrier: unknown key \"active_forces\" "
            "(mass, inertia_com, rotation_to_inertial, position_com, "
            "velocity_com, angular_velocity, active_force, "
            "active_moment_com)\n");
}

TEST(MultibodyEval, WhatDoesNotFitIsRefused) {
  const auto with = [](const std::string& place, const json& value) {
    json file = good();
    file[json::json_pointer(place)] = value;
    return message(file);
  };
  const auto begins = [](const std::string& text, const std::string& start) {
    EXPECT_EQ(text.substr(0, start.size()), start);
  };
  begins(with("/loads/2/friction_moment", {0, 0, 1}),
         "loads[2]: the body: unknown key \"friction_moment\" (");
  begins(with("/loads/1/angle", 0),
         "loads[1]: the body: unknown key \"angle\"");
  EXPECT_EQ(with("/kind", "axes"), "loads[1]: kind: not that of the file");
  EXPECT_EQ(with("/loads/1/kind", "cube"),
            "loads[1]: kind must be spherical, axis or free");
  EXPECT_EQ(with("/loads/0/held", true),
            "loads[0]: held: its rates and friction_moment must be 0");
  EXPECT_EQ(with("/loads/0/angular_velocity", {0, 1e-5, 0}),
            "loads[0]: angular_velocity: off by 1e-05 from the body's other "
            "data");
  EXPECT_EQ(with("/schema", "other"),
            "schema must be carrier-loads/1 or carrier-tree/1");
  EXPECT_EQ(with("/gravity_inertial", {0, 1}), "[0,1]: not 3 numbers");
}

json good_tree() {
  json file = good();
  json axis = file["loads"][0];
  json ball = file["loads"][1];
  for (const auto& [from, to] :
       {std::pair{"hinge_from_carrier_com", "hinge_from_parent_com"},
        std::pair{"hinge_to_load", "hinge_to_body"},
        std::pair{"hinge_to_carrier_zero", "hinge_to_parent_zero"},
        std::pair{"rotation_to_carrier", "rotation_to_parent"}}) {
    for (json* body : {&axis, &ball}) {
      if (!body->contains(from)) continue;
      (*body)[to] = (*body)[from];
      body->erase(from);
    }
  }
  axis["parent"] = 0;
  ball["parent"] = 1;
  ball["kind"] = "ball";
  for (const char* key : {"loads", "kind"}) file.erase(key);
  file["schema"] = "carrier-tree/1";
  file["bodies"] = {axis, ball};
  return file;
}

TEST(MultibodyEval, TreesHaveKeysOfTheirOwn) {
  ASSERT_EQ(message(good_tree()), "(no error)");
  const auto with = [](const std::string& place, const json& value) {
    json file = good_tree();
    file[json::json_pointer(place)] = value;
    return message(file);
  };
  EXPECT_EQ(with("/bodies/1/parent", 2),
            "bodies[1]: parent = 2 must be 0 or the number of a body before "
            "it");
  EXPECT_EQ(with("/bodies/0/parent", -1),
            "bodies[0]: parent = -1 must be 0 or the number of a body before "
            "it");
  EXPECT_EQ(with("/bodies/1/kind", "spherical"),
            "bodies[1]: kind must be ball or axis");
  EXPECT_EQ(with("/bodies/1/hinge_from_carrier_com", 0)
                .find("bodies[1]: the body: unknown key "
                      "\"hinge_from_carrier_com\" ("),
            0u);
  EXPECT_EQ(
      with("/loads", json::array()).find("the file: unknown key \"loads\" ("),
      0u);
  // Adds its own rate to the rate of its parent.
  EXPECT_EQ(with("/bodies/1/angular_velocity", {0, 1e-5, 0}),
            "bodies[1]: angular_velocity: off by 1e-05 from the body's other "
            "data");
  json spinning = good_tree();
  spinning["carrier"]["fixed"] = true;
  EXPECT_EQ(message(spinning), "(no error)");
  spinning["carrier"]["angular_velocity"] = {0, 0, 1};
  EXPECT_EQ(message(spinning),
            "carrier: fixed: its angular_velocity must be 0");
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
  for (const std::string key :
       {"/gravity_inertial", "/carrier", "/loads", "/schema", "/kind",
        "/carrier/mass", "/carrier/inertia_com",
        "/carrier/rotation_to_inertial", "/carrier/angular_velocity"}) {
    const json change = {{{"op", "remove"}, {"path", key}}};
    EXPECT_NE(
        message(good().patch(change))
            .find("key '" + key.substr(key.rfind('/') + 1) + "' not found"),
        std::string::npos)
        << key << ": " << message(good().patch(change));
  }
}

TEST(MultibodyEval, InertiaIsJudgedBesideTheLargest) {
  json file = good();
  file["carrier"]["inertia_com"] = {{1e20, 0, 0}, {0, 10, 0}, {0, 0, 10}};
  ProgramFolder folder;
  folder.write("c.json", file.dump());
  EXPECT_NE(folder.run("multibody-eval c.json")
                .err.find("c.json: carrier.inertia_com"),
            std::string::npos);
}

TEST(MultibodyEval, FilesThatCannotBeRead) {
  const ProgramFolder folder;
  const auto refused = [&](const std::string& file,
                           const std::string& expected) {
    const ProgramResult result = folder.run("multibody-eval " + file);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("multibody-eval: " + file + ": " + expected),
              std::string::npos)
        << result.err;
  };
  folder.write("empty.json", "");
  refused("empty.json", "[json.exception.parse_error");
  folder.write("large.json", "{\"a\": 1e400}");
  refused("large.json", "[json.exception.out_of_range");
  refused("none.json", "cannot be read: No such file or directory");
  refused("data", "cannot be read: a directory");
  refused("/dev/zero", "cannot be read: not a file");
}

}  // namespace
}  // namespace contact::test::eval_test
