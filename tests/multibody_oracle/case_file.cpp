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

// Names that differ between the two formats.
struct Format {
  std::string schema;
  std::string list;  ///< key of the list with bodies
  std::string from_parent_com, to_body, to_parent_zero, to_parent;
  bool is_tree = false;
};
const Format star = {"carrier-loads/1",        "loads",
                     "hinge_from_carrier_com", "hinge_to_load",
                     "hinge_to_carrier_zero",  "rotation_to_carrier"};
const Format tree = {"carrier-tree/1",
                     "bodies",
                     "hinge_from_parent_com",
                     "hinge_to_body",
                     "hinge_to_parent_zero",
                     "rotation_to_parent",
                     true};

const Keys carrier_keys = {
    "mass",         "inertia_com",      "rotation_to_inertial",
    "position_com", "velocity_com",     "angular_velocity",
    "active_force", "active_moment_com"};

Keys joined(Keys keys, const Keys& more) {
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

Keys file_keys(const Format& format) {
  Keys keys = {"schema", "name"};
  if (!format.is_tree) keys.emplace_back("kind");
  return joined(keys, {"seed", "oracle", "gravity_inertial", "carrier",
                       format.list, "expected"});
}

Keys keys_of(HingeKind kind, const Format& format) {
  Keys keys = {"kind",
               "mass",
               "inertia_com",
               format.to_parent,
               "relative_angular_velocity",
               "angular_velocity",
               "active_force",
               "active_moment_com"};
  if (format.is_tree) keys.emplace_back("parent");
  if (kind != HingeKind::none) {
    keys = joined(keys, {"held", "hinge_from_com", format.from_parent_com,
                         "friction_moment"});
  }
  if (kind == HingeKind::axis) {
    keys = joined(
        keys, {format.to_body, format.to_parent_zero, "angle", "angle_rate"});
  }
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

Matrix3d rotation(const json& object, const std::string& key) {
  return checked_rotation(matrix(object.at(key)), key);
}

HingeKind kind_in_tree(const json& body) {
  const std::string kind = body.at("kind");
  if (kind == "axis") return HingeKind::axis;
  if (kind != "ball") throw contact::Error("kind must be ball or axis");
  return HingeKind::ball;
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

Body read_body(const json& object, HingeKind kind, const Format& format) {
  Body body;
  if (format.is_tree) body.parent = object.at("parent").get<int>() - 1;
  body.kind = kind;
  body.mass = object.at("mass");
  body.inertia = matrix(object.at("inertia_com"));
  if (kind != HingeKind::none) {
    body.hinge_from_com = vector(object.at("hinge_from_com"));
    body.hinge_from_carrier_com = vector(object.at(format.from_parent_com));
  }
  if (kind == HingeKind::axis) {
    body.hinge_to_body = rotation(object, format.to_body);
    body.hinge_to_carrier_zero = rotation(object, format.to_parent_zero);
  }
  return body;
}

// Checks that data given twice agree.
void check_agreement(const std::string& key, double difference, double size) {
  if (!(difference <= agreement * size)) {
    throw contact::Error(fmt::format("{}: off by {} from the body's other data",
                                     key, difference));
  }
}

void read_motion(const json& object, const Vector3d& parent_velocity,
                 const Format& format, BodyInstant& body) {
  if (body.body.kind == HingeKind::axis) {
    body.angle = object.at("angle");
    body.angle_rate = object.at("angle_rate");
    body.rotation = axis_rotation(body.body, body.angle);
    body.relative_angular_velocity =
        body.angle_rate * body.body.hinge_to_body.col(2);
  } else {
    body.rotation = rotation(object, format.to_parent);
    body.relative_angular_velocity =
        vector(object.at("relative_angular_velocity"));
  }
  const Vector3d w = body.rotation.transpose() * parent_velocity +
                     body.relative_angular_velocity;
  if (object.contains(format.to_parent)) {
    check_agreement(format.to_parent,
                    (rotation(object, format.to_parent) - body.rotation)
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
                              const Vector3d& parent_velocity,
                              const Format& format) {
  BodyInstant body;
  body.body = read_body(object, kind, format);
  body.mode = kind == HingeKind::none       ? JointMode::released
              : object.value("held", false) ? JointMode::held
                                            : JointMode::turning;
  read_motion(object, parent_velocity, format, body);
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

ordered_json to_json(const BodyInstant& body, const BodyResult& result,
                     bool is_tree) {
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
  if (axis && !is_tree) {
    object["reaction_moment_hinge_xy"] = {result.reaction_moment_hinge.x(),
                                          result.reaction_moment_hinge.y()};
  }
  object["reaction_moment"] = array(result.reaction_moment);
  return object;
}

const Format& format_of(const json& file) {
  // A file without a schema is a star; its keys are read next.
  const std::string schema = file.value("schema", star.schema);
  if (schema == star.schema) return star;
  if (schema == tree.schema) return tree;
  throw contact::Error(
      fmt::format("schema must be {} or {}", star.schema, tree.schema));
}

// Absolute angular velocity of the body that a body hangs on, its own axes.
Vector3d parent_velocity(const json& object, const Instant& instant) {
  const int size = static_cast<int>(instant.bodies.size());
  int at = object.value("parent", 0);
  if (at < 0 || at > size) {
    throw contact::Error(fmt::format(
        "parent = {} must be 0 or the number of a body before it", at));
  }
  Vector3d w = Vector3d::Zero();
  Matrix3d to_first = Matrix3d::Identity();
  for (; at > 0; at = instant.bodies[at - 1].body.parent + 1) {
    const BodyInstant& body = instant.bodies[at - 1];
    w += to_first * body.relative_angular_velocity;
    to_first *= body.rotation.transpose();
  }
  return w + to_first * instant.angular_velocity;
}

void read_carrier(const json& carrier, Instant& instant) {
  instant.carrier.fixed = carrier.value("fixed", false);
  if (!instant.carrier.fixed) {
    instant.carrier.mass = carrier.at("mass");
    instant.carrier.inertia = matrix(carrier.at("inertia_com"));
  }
  instant.rotation = rotation(carrier, "rotation_to_inertial");
  instant.position = vector_or_zero(carrier, "position_com");
  instant.velocity = vector_or_zero(carrier, "velocity_com");
  instant.angular_velocity = vector(carrier.at("angular_velocity"));
  instant.active_force = vector_or_zero(carrier, "active_force");
  instant.active_moment_com = vector_or_zero(carrier, "active_moment_com");
  if (instant.carrier.fixed && !instant.angular_velocity.isZero(0)) {
    throw contact::Error("carrier: fixed: its angular_velocity must be 0");
  }
}

}  // namespace

CaseInstant instant_from_json(const json& file) {
  const Format& format = format_of(file);
  refuse_keys_beside(file, file_keys(format), "the file");
  static_cast<void>(file.at("schema"));  // must be there all the same
  CaseInstant instant;
  instant.is_tree = format.is_tree;
  instant.gravity = vector(file.at("gravity_inertial"));
  const json& carrier = file.at("carrier");
  refuse_keys_beside(
      carrier, format.is_tree ? joined({"fixed"}, carrier_keys) : carrier_keys,
      "carrier");
  read_carrier(carrier, instant);
  for (const json& object : file.at(format.list)) {
    const std::string place =
        fmt::format("{}[{}]", format.list, instant.bodies.size());
    try {
      const HingeKind kind = format.is_tree ? kind_in_tree(object)
                                            : kind_of(object, file.at("kind"));
      refuse_keys_beside(object, keys_of(kind, format), "the body");
      instant.bodies.push_back(read_body_instant(
          object, kind, parent_velocity(object, instant), format));
    } catch (const std::exception& error) {
      throw contact::Error(fmt::format("{}: {}", place, error.what()));
    }
  }
  return instant;
}

CaseInstant read_case(const std::string& file) {
  const std::string text = contact::detail::file_text(file);
  try {
    CaseInstant instant = instant_from_json(json::parse(text));
    prepare(instant);  // System's checks, with the file's name
    return instant;
  } catch (const std::exception& error) {
    throw contact::Error(file + ": " + error.what());
  }
}

ordered_json to_json(const CaseInstant& instant, const InstantResult& result) {
  ordered_json object;
  object["carrier_acceleration"] = array(result.acceleration);
  object["carrier_acceleration_minus_gravity"] =
      array(result.acceleration_minus_gravity);
  object["carrier_angular_acceleration"] = array(result.angular_acceleration);
  ordered_json& list = object[(instant.is_tree ? tree : star).list];
  list = ordered_json::array();
  for (std::size_t i = 0; i < instant.bodies.size(); ++i) {
    list.push_back(
        to_json(instant.bodies[i], result.bodies[i], instant.is_tree));
  }
  return object;
}

}  // namespace multibody
