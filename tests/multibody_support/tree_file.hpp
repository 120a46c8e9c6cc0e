#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "libcontact/files/joint_file.hpp"
#include "multibody/motion/motion.hpp"

/// Instants of trees as motions: data/reference/trees/README.md.
namespace multibody::test {

inline Eigen::Vector3d vector_of(const nlohmann::json& j) {
  return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()};
}

inline Eigen::Matrix3d matrix_of(const nlohmann::json& j) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i) m.row(i) = vector_of(j.at(i));
  return m;
}

/// Loads that are constant in body axes (0: the carrier), and moments between a
/// body and its parent.
struct BodyLoads : ForceModel {
  struct Load {
    int parent = -1;  ///< place; -1: none
    Eigen::Vector3d force, moment;
    Eigen::Vector3d pair = Eigen::Vector3d::Zero();
  };
  std::vector<Load> loads;
  void add_forces(double, std::span<const BodyMotion> bodies,
                  std::span<BodyForce> forces) const override {
    for (std::size_t i = 0; i < loads.size(); ++i) {
      const Eigen::Matrix3d& r = bodies[i].rotation;
      forces[i].force += r * loads[i].force;
      forces[i].moment += r * (loads[i].moment + loads[i].pair);
      if (loads[i].parent < 0) continue;
      forces[loads[i].parent].moment -= r * loads[i].pair;
    }
  }
};

struct TreeFile {
  std::string name;
  Carrier carrier;
  std::vector<Body> bodies;
  std::vector<HingeFriction> friction;  ///< none of most files
  std::shared_ptr<BodyLoads> forces = std::make_shared<BodyLoads>();
  MotionStart start;
  MotionOptions options;
  nlohmann::json expected;

  Motion motion() const {
    return {System(carrier, bodies), friction, forces, start, options};
  }
};

inline void read_body(const nlohmann::json& b, TreeFile& tree) {
  const bool axis = b.at("kind") == "axis";
  const bool held = b.at("held");
  Body body{axis ? HingeKind::axis : HingeKind::ball, b.at("mass"),
            matrix_of(b.at("inertia_com")), vector_of(b.at("hinge_from_com")),
            vector_of(b.at("hinge_from_parent_com"))};
  body.parent = b.at("parent").get<int>() - 1;
  BodyStart start;
  BodyLoads::Load load{b.at("parent"), vector_of(b.at("active_force")),
                       vector_of(b.at("active_moment_com")),
                       vector_of(b.at("friction_moment"))};
  if (axis) {
    body.hinge_to_body = matrix_of(b.at("hinge_to_body"));
    body.hinge_to_carrier_zero = matrix_of(b.at("hinge_to_parent_zero"));
    start.angle = b.at("angle");
    start.angle_rate = b.at("angle_rate");
    load.pair = body.hinge_to_body * load.pair;
  } else {
    start.rotation = matrix_of(b.at("rotation_to_parent"));
    start.relative_angular_velocity =
        vector_of(b.at("relative_angular_velocity"));
  }
  if (held) load.pair.setZero();
  start.locked = held && tree.friction.empty();
  tree.bodies.push_back(body);
  tree.start.bodies.push_back(start);
  tree.forces->loads.push_back(load);
}

/// @param file  the joints of its friction are in the same folder
inline TreeFile read_tree(const std::filesystem::path& file) {
  std::ifstream stream(file);
  const nlohmann::json all = nlohmann::json::parse(stream);
  TreeFile tree;
  tree.name = file.filename().string();
  tree.options.gravity = vector_of(all.at("gravity_inertial"));
  tree.expected = all.at("expected");
  const nlohmann::json& c = all.at("carrier");
  tree.carrier.fixed = c.value("fixed", false);
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  BodyLoads::Load load{-1, none, none};
  BodyMotion& start = tree.start.carrier;
  if (c.contains("rotation_to_inertial")) {
    start.rotation = matrix_of(c.at("rotation_to_inertial"));
  }
  if (!tree.carrier.fixed) {
    tree.carrier.mass = c.at("mass");
    tree.carrier.inertia = matrix_of(c.at("inertia_com"));
    start.position = vector_of(c.at("position_com"));
    start.velocity = vector_of(c.at("velocity_com"));
    start.angular_velocity =
        start.rotation * vector_of(c.at("angular_velocity"));
    load = {-1, vector_of(c.at("active_force")),
            vector_of(c.at("active_moment_com"))};
  }
  tree.forces->loads.push_back(load);
  if (all.contains("friction_joints")) {
    for (const std::string name : all.at("friction_joints")) {
      tree.friction.push_back(JointFriction{
          contact::Joint(contact::read_joint(file.parent_path() / name))});
    }
  }
  for (const nlohmann::json& b : all.at("bodies")) read_body(b, tree);
  return tree;
}

/// All files of a folder of data/reference.
inline std::vector<TreeFile> read_trees(const std::string& folder) {
  std::vector<TreeFile> all;
  for (const auto& entry : std::filesystem::directory_iterator(
           std::string(CONTACT_DATA_DIR "/reference/") + folder)) {
    if (entry.path().extension() == ".json") {
      all.push_back(read_tree(entry.path()));
    }
  }
  return all;
}

}  // namespace multibody::test
