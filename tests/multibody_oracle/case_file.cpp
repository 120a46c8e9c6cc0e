#include "multibody_oracle/case_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/base/error.hpp"
#include "libcontact/base/file_text.hpp"
#include "multibody_support/prepared.hpp"

namespace multibody {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using nlohmann::json;
using nlohmann::ordered_json;
using Keys = std::vector<std::string_view>;

// Redundant data may come from seven printed digits.
constexpr double agreement = 1e-6;

const Keys file_keys = {"schema",  "name",   "kind",
                        "seed",    "oracle", "gravity_inertial",
                        "carrier", "loads",  "expected"};
const Keys carrier_keys = {
    "mass",         "inertia_com",      "rotation_to_inertial",
    "position_com", "velocity_com",     "angular_velocity",
    "active_force", "active_moment_com"};
const Keys free_keys = {"kind",
                        "mass",
                        "inertia_com",
                        "rotation_to_carrier",
                        "relative_angular_velocity",
                        "angular_velocity",
                        "active_force",
                        "active_moment_com"};
const Keys ball_keys = {"held", "hinge_from_com", "hinge_from_carrier_com",
                        "friction_moment"};
const Keys axis_keys = {"hinge_to_load", "hinge_to_carrier_zero", "angle",
                        "angle_rate"};

Keys keys_of(HingeKind kind) {
  Keys keys = free_keys;
  const auto add = [&](const Keys& more) {
    keys.insert(keys.end(), more.begin(), more.end());
  };
  if (kind != HingeKind::none) add(ball_keys);
  if (kind == HingeKind::axis) add(axis_keys);
  return keys;
}

// A misspelt key would be passed over.
void refuse_keys_beside(const json& object, const Keys& keys,
                        std::string_view place) {
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(keys, key) == keys.end()) {
      throw contact::Error(fmt::format("{}: unknown key \"{}\" ({})", place,
                                       key, fmt::join(keys, ", ")));
    }
  }
}

Vector3d vector(const json& rows) {
  if (rows.size() != 3) throw contact::Error(rows.dump() + ": not 3 numbers");
  return Vector3d(rows.at(0), rows.at(1), rows.at(2));
}

Vector3d vector_or_zero(const json& object, const char* key) {
  return object.contains(key) ? vector(object[key]) : Vector3d::Zero();
}

Matrix3d matrix(const json& rows) {
  if (rows.size() != 3) throw contact::Error(rows.dump() + ": not 3 rows");
  Matrix3d result;
  for (int i = 0; i < 3; ++i) result.row(i) = vector(rows[i]).transpose();
  return result;
}

Matrix3d rotation(const json& object, const char* key) {
  return checked_rotation(matrix(object.at(key)), key);
}

HingeKind kind_of(const json& body, const std::string& kind_of_all) {
  std::string kind = kind_of_all == "axes" ? "axis" : kind_of_all;
  if (kind == "mixed") kind = body.at("kind");
  if (body.value("kind", kind) != kind) {
    throw contact::Error("kind: not that of the file");
  }
  if (kind == "spherical") return HingeKind::ball;
  if (kind == "axis") return HingeKind::axis;
  if (kind == "free") return HingeKind::none;
  throw contact::Error("kind must be spherical, axis or free");
}

Body read_body(const json& object, HingeKind kind) {
  Body body;
  body.kind = kind;
  body.mass = object.at("mass");
  body.inertia = matrix(object.at("inertia_com"));
  if (kind != HingeKind::none) {
    body.hinge_from_com = vector(object.at("hinge_from_com"));
    body.hinge_from_carrier_com = vector(object.at("hinge_from_carrier_com"));
  }
  if (kind == HingeKind::axis) {
    body.hinge_to_body = rotation(object, "hinge_to_load");
    body.hinge_to_carrier_zero = rotation(object, "hinge_to_carrier_zero");
  }
  return body;
}

// Checks that data given twice agree.
void check_agreement(const char* key, double difference, double size) {
  if (!(difference <= agreement * size)) {
    throw contact::Error(fmt::format("{}: off by {} from the body's other data",
                                     key, difference));
  }
}

void read_motion(const json& object, const Vector3d& carrier_velocity,
                 BodyInstant& body) {
  if (body.body.kind == HingeKind::axis) {
    body.angle = object.at("angle");
    body.angle_rate = object.at("angle_rate");
    body.rotation = axis_rotation(body.body, body.angle);
    body.relative_angular_velocity =
        body.angle_rate * body.body.hinge_to_body.col(2);
  } else {
    body.rotation = rotation(object, "rotation_to_carrier");
    body.relative_angular_velocity =
        vector(object.at("relative_angular_velocity"));
  }
  const Vector3d w = body.rotation.transpose() * carrier_velocity +
                     body.relative_angular_velocity;
  if (object.contains("rotation_to_carrier")) {
    check_agreement("rotation_to_carrier",
                    (rotation(object, "rotation_to_carrier") - body.rotation)
                        .cwiseAbs()
                        .maxCoeff(),
                    1);
  }
  for (const auto& [key, value] :
       {std::pair{"relative_angular_velocity", body.relative_angular_velocity},
        std::pair{"angular_velocity", w}}) {
    if (!object.contains(key)) continue;
    check_agreement(key, (vector(object[key]) - value).norm(),
                    1 + value.norm());
  }
}

BodyInstant read_body_instant(const json& object, HingeKind kind,
                              const Vector3d& carrier_velocity) {
  BodyInstant body;
  body.body = read_body(object, kind);
  body.mode = kind == HingeKind::none       ? JointMode::released
              : object.value("held", false) ? JointMode::held
                                            : JointMode::turning;
  read_motion(object, carrier_velocity, body);
  body.active_force = vector_or_zero(object, "active_force");
  body.active_moment_com = vector_or_zero(object, "active_moment_com");
  body.friction_moment = vector_or_zero(object, "friction_moment");
  if (body.mode == JointMode::held &&
      !(body.relative_angular_velocity.isZero(0) &&
        body.friction_moment.isZero(0))) {
    throw contact::Error("held: its rates and friction_moment must be 0");
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
  refuse_keys_beside(file, file_keys, "the file");
  if (file.at("schema") != "carrier-loads/1") {
    throw contact::Error("schema must be carrier-loads/1");
  }
  const json& carrier = file.at("carrier");
  refuse_keys_beside(carrier, carrier_keys, "carrier");
  Instant instant;
  instant.carrier = {carrier.at("mass"), matrix(carrier.at("inertia_com"))};
  instant.gravity = vector(file.at("gravity_inertial"));
  instant.rotation = rotation(carrier, "rotation_to_inertial");
  instant.position = vector_or_zero(carrier, "position_com");
  instant.velocity = vector_or_zero(carrier, "velocity_com");
  instant.angular_velocity = vector(carrier.at("angular_velocity"));
  instant.active_force = vector_or_zero(carrier, "active_force");
  instant.active_moment_com = vector_or_zero(carrier, "active_moment_com");
  for (const json& object : file.at("loads")) {
    const std::string place = fmt::format("loads[{}]", instant.bodies.size());
    try {
      const HingeKind kind = kind_of(object, file.at("kind"));
      refuse_keys_beside(object, keys_of(kind), "the body");
      instant.bodies.push_back(
          read_body_instant(object, kind, instant.angular_velocity));
    } catch (const std::exception& error) {
      throw contact::Error(fmt::format("{}: {}", place, error.what()));
    }
  }
  return instant;
}

Instant read_case(const std::string& file) {
  const std::string text = contact::detail::file_text(file);
  try {
    Instant instant = instant_from_json(json::parse(text));
    prepare(instant);  // System's checks, with the file's name
    return instant;
  } catch (const std::exception& error) {
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
