#include "multibody/case_file.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>

#include "libcontact/error.hpp"
#include "multibody/json_node.hpp"

namespace multibody {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using nlohmann::json;

constexpr const char* schema = "carrier-loads/1";

// Redundant data may come from seven printed digits.
constexpr double agreement = 1e-6;

// What a load is at this instant.
struct LoadKind {
  JointKind joint;
  JointMode mode;
};

LoadKind load_kind(const JsonNode& load, const std::string& kind_of_all) {
  if (kind_of_all == "spherical") {
    return {JointKind::spherical, JointMode::turning};
  }
  if (kind_of_all == "axes") return {JointKind::axis, JointMode::turning};
  const std::string kind = load["kind"].string();
  if (kind == "spherical") return {JointKind::spherical, JointMode::turning};
  if (kind == "axis") return {JointKind::axis, JointMode::turning};
  if (kind == "held") return {JointKind::spherical, JointMode::held};
  if (kind == "free") return {JointKind::none, JointMode::released};
  fail(load["kind"].place(),
       fmt::format("\"{}\", allowed are spherical, axis, held, free", kind));
}

Load read_load(const JsonNode& node, JointKind kind) {
  Load load;
  load.kind = kind;
  load.mass = node["mass"].number();
  load.inertia = node["inertia_com"].matrix();
  if (kind != JointKind::none) {
    load.hinge_from_com = node["hinge_from_com"].vector();
    load.hinge_from_carrier_com = node["hinge_from_carrier_com"].vector();
  }
  if (kind == JointKind::axis) {
    load.hinge_to_load = node["hinge_to_load"].matrix();
    load.hinge_to_carrier_zero = node["hinge_to_carrier_zero"].matrix();
  }
  return load;
}

void check_agreement(double error, double scale, const JsonNode& node,
                     const char* key) {
  if (error <= agreement * scale) return;
  fail(node[key].place(),
       fmt::format("does not agree with the other data of the load, off by "
                   "{}, allowed is {}",
                   error, agreement * scale));
}

// Relative motion of a load, given axes.
struct RelativeMotion {
  Matrix3d rotation;
  Vector3d angular_velocity;
  double angle = 0;
  double rate = 0;
};

RelativeMotion read_motion(const JsonNode& node, LoadKind kind) {
  if (kind.joint != JointKind::axis) {
    return {node["rotation_to_carrier"].rotation(),
            kind.mode == JointMode::held
                ? node.vector_or_zero("relative_angular_velocity")
                : node["relative_angular_velocity"].vector()};
  }
  RelativeMotion motion;
  motion.angle = node["angle"].number();
  motion.rate = node["angle_rate"].number();
  const Matrix3d to_load = node["hinge_to_load"].rotation();
  motion.rotation =
      node["hinge_to_carrier_zero"].rotation() *
      Eigen::AngleAxisd(motion.angle, Vector3d::UnitZ()).toRotationMatrix() *
      to_load.transpose();
  motion.angular_velocity = motion.rate * to_load.col(2);
  if (node.has("rotation_to_carrier")) {
    const Matrix3d given = node["rotation_to_carrier"].rotation();
    check_agreement((given - motion.rotation).cwiseAbs().maxCoeff(), 1, node,
                    "rotation_to_carrier");
  }
  if (node.has("relative_angular_velocity")) {
    const Vector3d given = node["relative_angular_velocity"].vector();
    check_agreement((given - motion.angular_velocity).norm(),
                    1 + std::abs(motion.rate), node,
                    "relative_angular_velocity");
  }
  return motion;
}

void put_vector(const Vector3d& v, double* to) {
  for (int i = 0; i < 3; ++i) to[i] = v[i];
}
void put_rotation(const Matrix3d& rotation, double* to) {
  const Eigen::Quaterniond q(rotation);
  to[0] = q.w();
  to[1] = q.x();
  to[2] = q.y();
  to[3] = q.z();
}

Case read(const json& file) {
  const JsonNode root(file, "");
  if (!file.is_object()) fail("", "allowed is an object");
  const std::string found = root["schema"].string();
  if (found != schema) {
    fail("schema", fmt::format("\"{}\", allowed is \"{}\"", found, schema));
  }
  const std::string kind = root["kind"].string();
  if (kind != "spherical" && kind != "axes" && kind != "mixed") {
    fail("kind",
         fmt::format("\"{}\", allowed are spherical, axes, mixed", kind));
  }
  const JsonNode carrier = root["carrier"];
  const JsonNode loads = root["loads"].array();
  std::vector<LoadKind> kinds;
  std::vector<Load> descriptions;
  std::vector<JointMode> modes;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    kinds.push_back(load_kind(loads[i], kind));
    modes.push_back(kinds[i].mode);
    descriptions.push_back(read_load(loads[i], kinds[i].joint));
  }
  Case c{root.has("name") ? root["name"].string() : "",
         System({carrier["mass"].number(), carrier["inertia_com"].matrix()},
                descriptions),
         std::move(modes),
         {},
         {},
         root.has("gravity_inertial") ? root["gravity_inertial"].vector()
                                      : Vector3d::Zero()};

  const StateLayout layout(c.system, c.modes);
  c.state.resize(layout.size());
  const Vector3d w0 = carrier["angular_velocity"].vector();
  put_vector(carrier.vector_or_zero("position_com"),
             &c.state[StateLayout::position]);
  put_vector(carrier.vector_or_zero("velocity_com"),
             &c.state[StateLayout::velocity]);
  put_rotation(carrier["rotation_to_inertial"].rotation(),
               &c.state[StateLayout::rotation]);
  put_vector(w0, &c.state[StateLayout::angular_velocity]);
  c.loading.carrier_force = vec3(carrier.vector_or_zero("active_force"));
  c.loading.carrier_moment = vec3(carrier.vector_or_zero("active_moment_com"));

  for (std::size_t i = 0; i < loads.size(); ++i) {
    const JsonNode node = loads[i];
    const Link& link = c.system.links()[i];
    const RelativeMotion motion = read_motion(node, kinds[i]);
    const Vector3d w =
        motion.rotation.transpose() * w0 + motion.angular_velocity;
    if (node.has("angular_velocity")) {
      check_agreement((node["angular_velocity"].vector() - w).norm(),
                      1 + w.norm(), node, "angular_velocity");
    }
    double* const to = &c.state[layout.offset(static_cast<int>(i))];
    if (c.modes[i] == JointMode::released) {
      put_rotation(carrier["rotation_to_inertial"].rotation() *
                       motion.rotation * link.axes,
                   to + StateLayout::rotation);
      put_vector(link.axes.transpose() * w, to + StateLayout::angular_velocity);
    } else if (link.kind == JointKind::axis) {
      to[0] = motion.angle;
      to[1] = motion.rate;
    } else {
      put_rotation(motion.rotation * link.axes, to);
      put_vector(link.axes.transpose() * motion.angular_velocity, to + 4);
    }
    const Matrix3d to_axes = link.axes.transpose();
    const Matrix3d friction_to_axes =
        link.kind == JointKind::axis ? link.axes_to_hinge.transpose() : to_axes;
    const Vector3d friction =
        friction_to_axes * node.vector_or_zero("friction_moment");
    c.loading.loads.push_back(
        {vec3(to_axes * node.vector_or_zero("active_force")),
         vec3(to_axes * node.vector_or_zero("active_moment_com")),
         vec3(friction)});
  }
  return c;
}

}  // namespace

Case read_case(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) fail(file, "cannot be read");
  json parsed;
  try {
    parsed = json::parse(stream);
  } catch (const json::parse_error& error) {
    fail(file, fmt::format("not JSON at byte {}", error.byte));
  }
  try {
    return read(parsed);
  } catch (const contact::Error& error) {
    fail(file, error.what());
  }
}

}  // namespace multibody
