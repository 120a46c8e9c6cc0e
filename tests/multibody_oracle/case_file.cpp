#include "multibody_oracle/case_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "cli/file_text.hpp"
#include "libcontact/base/error.hpp"
#include "multibody_oracle/json_node.hpp"
#include "multibody_oracle/json_text.hpp"
#include "multibody_support/prepared.hpp"

namespace multibody {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* schema = "carrier-loads/1";

// Redundant data may come from seven printed digits.
constexpr double agreement = 1e-6;

// Of what is computed or of where the case is from.
void check_root_keys(const JsonNode& root) {
  static const std::vector<std::string> keys = {
      "schema",           "name",    "kind",  "seed",    "oracle",
      "gravity_inertial", "carrier", "loads", "expected"};
  root.allow_keys(keys, "the file");
}

void check_carrier_keys(const JsonNode& carrier) {
  static const std::vector<std::string> keys = {
      "mass",         "inertia_com",      "rotation_to_inertial",
      "position_com", "velocity_com",     "angular_velocity",
      "active_force", "active_moment_com"};
  carrier.allow_keys(keys, "the carrier");
}

void check_body_keys(const JsonNode& body, HingeKind kind) {
  static const std::vector<std::string> free = {"kind",
                                                "mass",
                                                "inertia_com",
                                                "rotation_to_carrier",
                                                "relative_angular_velocity",
                                                "angular_velocity",
                                                "active_force",
                                                "active_moment_com"};
  static const auto with = [](std::vector<std::string> keys,
                              const std::vector<std::string>& more) {
    keys.insert(keys.end(), more.begin(), more.end());
    return keys;
  };
  static const std::vector<std::string> spherical = with(
      free,
      {"held", "hinge_from_com", "hinge_from_carrier_com", "friction_moment"});
  static const std::vector<std::string> axis =
      with(spherical,
           {"hinge_to_load", "hinge_to_carrier_zero", "angle", "angle_rate"});
  switch (kind) {
    case HingeKind::none:
      return body.allow_keys(free, "a free load");
    case HingeKind::ball:
      return body.allow_keys(spherical, "a load on a ball joint");
    case HingeKind::axis:
      return body.allow_keys(axis, "a load on an axis");
  }
}

HingeKind own_kind(const JsonNode& node) {
  const std::string kind = node.string();
  if (kind == "spherical") return HingeKind::ball;
  if (kind == "axis") return HingeKind::axis;
  if (kind == "free") return HingeKind::none;
  node.fail("spherical, axis or free");
}

HingeKind body_kind(const JsonNode& body, const std::string& kind_of_all) {
  if (kind_of_all == "mixed") return own_kind(body["kind"]);
  const bool spherical = kind_of_all == "spherical";
  const HingeKind kind = spherical ? HingeKind::ball : HingeKind::axis;
  if (body.has("kind") && own_kind(body["kind"]) != kind) {
    body["kind"].fail(spherical ? "spherical, the file's kind"
                                : "axis, the file's kind");
  }
  return kind;
}

JointMode body_mode(const JsonNode& body, HingeKind kind) {
  if (kind == HingeKind::none) return JointMode::released;
  return body.has("held") && body["held"].boolean() ? JointMode::held
                                                    : JointMode::turning;
}

Body read_body(const JsonNode& node, HingeKind kind) {
  Body body;
  body.kind = kind;
  body.mass = node["mass"].number();
  body.inertia = node["inertia_com"].matrix();
  if (kind != HingeKind::none) {
    body.hinge_from_com = node["hinge_from_com"].vector();
    body.hinge_from_carrier_com = node["hinge_from_carrier_com"].vector();
  }
  if (kind == HingeKind::axis) {
    body.hinge_to_body = node["hinge_to_load"].rotation();
    body.hinge_to_carrier_zero = node["hinge_to_carrier_zero"].rotation();
  }
  return body;
}

void check_agreement(double error, double scale, const JsonNode& node,
                     const char* key) {
  if (error <= agreement * scale) return;
  node[key].fail(
      fmt::format("a value that agrees with the load's other data "
                  "to {} (off by {})",
                  agreement * scale, error));
}

void read_turn(const JsonNode& node, BodyInstant& body) {
  body.angle = node["angle"].number();
  body.angle_rate = node["angle_rate"].number();
  body.rotation = axis_rotation(body.body, body.angle);
  body.relative_angular_velocity =
      body.angle_rate * body.body.hinge_to_body.col(2);
  if (node.has("rotation_to_carrier")) {
    const Matrix3d given = node["rotation_to_carrier"].rotation();
    check_agreement((given - body.rotation).cwiseAbs().maxCoeff(), 1, node,
                    "rotation_to_carrier");
  }
  if (node.has("relative_angular_velocity")) {
    const Vector3d given = node["relative_angular_velocity"].vector();
    check_agreement((given - body.relative_angular_velocity).norm(),
                    1 + std::abs(body.angle_rate), node,
                    "relative_angular_velocity");
  }
}

BodyInstant read_body_instant(const JsonNode& node, HingeKind kind,
                              const Vector3d& carrier_velocity) {
  check_body_keys(node, kind);
  BodyInstant body;
  body.body = read_body(node, kind);
  body.mode = body_mode(node, kind);
  if (kind == HingeKind::axis) {
    read_turn(node, body);
  } else {
    body.rotation = node["rotation_to_carrier"].rotation();
    body.relative_angular_velocity = node["relative_angular_velocity"].vector();
  }
  if (body.mode == JointMode::held &&
      !body.relative_angular_velocity.isZero(0)) {
    node[kind == HingeKind::axis ? "angle_rate" : "relative_angular_velocity"]
        .fail("0, since the joint is held");
  }
  if (node.has("angular_velocity")) {
    const Vector3d w = body.rotation.transpose() * carrier_velocity +
                       body.relative_angular_velocity;
    check_agreement((node["angular_velocity"].vector() - w).norm(),
                    1 + w.norm(), node, "angular_velocity");
  }
  body.active_force = node.vector_or_zero("active_force");
  body.active_moment_com = node.vector_or_zero("active_moment_com");
  body.friction_moment = node.vector_or_zero("friction_moment");
  if (body.mode == JointMode::held && !body.friction_moment.isZero(0)) {
    node["friction_moment"].fail("0, since the joint is held");
  }
  return body;
}

ordered_json array(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

ordered_json to_json(const BodyInstant& body, const BodyResult& result) {
  ordered_json object;
  object["acceleration_com"] = array(result.acceleration);
  object["angular_acceleration"] = array(result.angular_acceleration);
  if (body.body.kind == HingeKind::none) return object;
  const bool axis = body.body.kind == HingeKind::axis;
  if (axis) {
    object["angle_acceleration"] = result.angle_acceleration;
  } else {
    object["relative_angular_acceleration"] =
        array(result.relative_angular_acceleration);
  }
  object["reaction_force"] = array(result.reaction_force);
  if (axis) {
    object["reaction_moment_hinge_xy"] = {result.reaction_moment_hinge.x(),
                                          result.reaction_moment_hinge.y()};
  }
  object["reaction_moment"] = array(result.reaction_moment);
  return object;
}

}  // namespace

Instant instant_from_json(const json& file) {
  const JsonNode root(file, "");
  if (root["schema"].string() != schema) root["schema"].fail(schema);
  const std::string kind = root["kind"].string();
  if (kind != "spherical" && kind != "axes" && kind != "mixed") {
    root["kind"].fail("spherical, axes or mixed");
  }
  check_root_keys(root);
  const JsonNode carrier = root["carrier"];
  check_carrier_keys(carrier);
  Instant instant;
  instant.carrier = {carrier["mass"].number(), carrier["inertia_com"].matrix()};
  instant.gravity = root["gravity_inertial"].vector();
  instant.rotation = carrier["rotation_to_inertial"].rotation();
  instant.position = carrier.vector_or_zero("position_com");
  instant.velocity = carrier.vector_or_zero("velocity_com");
  instant.angular_velocity = carrier["angular_velocity"].vector();
  instant.active_force = carrier.vector_or_zero("active_force");
  instant.active_moment_com = carrier.vector_or_zero("active_moment_com");
  const JsonNode bodies = root["loads"];
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    instant.bodies.push_back(read_body_instant(
        bodies[i], body_kind(bodies[i], kind), instant.angular_velocity));
  }
  return instant;
}

Instant read_case(const std::string& file) {
  const std::string text = cli::file_text(file);
  if (text.empty()) throw contact::Error(file + ": empty");
  const json parsed = parse_json(text, file);
  try {
    Instant instant = instant_from_json(parsed);
    prepare(instant);  // System's checks, with the file's name
    return instant;
  } catch (const contact::Error& error) {
    throw contact::Error(file + ": " + error.what());
  }
}

ordered_json to_json(const Instant& instant, const InstantResult& result) {
  ordered_json object;
  object["carrier_acceleration"] = array(result.acceleration);
  object["carrier_acceleration_minus_gravity"] =
      array(result.acceleration_minus_gravity);
  object["carrier_angular_acceleration"] = array(result.angular_acceleration);
  object["loads"] = ordered_json::array();
  for (std::size_t i = 0; i < instant.bodies.size(); ++i) {
    object["loads"].push_back(to_json(instant.bodies[i], result.bodies[i]));
  }
  return object;
}

}  // namespace multibody
