// Bodies on bodies at one instant, as System and Motion have them: against
// other programs, without and with friction.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "libcontact/base/error.hpp"
#include "multibody_support/tree_file.hpp"

namespace multibody::test::tree_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using nlohmann::json;

// The largest difference of a quantity over its largest component.
struct Difference {
  double difference = 0, size = 0;
  void add(const Vector3d& a, const Vector3d& b) {
    const double d = (a - b).cwiseAbs().maxCoeff();
    difference = d <= difference ? difference : d;  // keeps a NaN
    size = std::max(size, b.cwiseAbs().maxCoeff());
  }
  double relative() const { return size > 0 ? difference / size : difference; }
};

void compare_bodies(const TreeFile& tree, const MotionSample& sample,
                    double bar) {
  Difference linear, angular, force, moment;
  for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
    const json& e = tree.expected["bodies"][i];
    const int body = static_cast<int>(i);
    const Matrix3d to_body = sample.body(body).rotation.transpose();
    const HingeSample hinge = sample.hinge(body);
    linear.add(to_body * sample.acceleration(1 + body),
               vector_of(e["acceleration_com"]));
    angular.add(to_body * sample.angular_acceleration(1 + body),
                vector_of(e["angular_acceleration"]));
    force.add(hinge.reaction_force, vector_of(e["reaction_force"]));
    Vector3d held = vector_of(e["reaction_moment"]);
    moment.add(hinge.reaction_moment, held);
  }
  // Balls alone: the oracle's moments are the rounding of force times some
  // metre, ours are 0.
  if (moment.size < 1e-9 * force.size) moment.size = force.size;
  EXPECT_LE(linear.relative(), bar) << tree.name;
  EXPECT_LE(angular.relative(), bar) << tree.name;
  EXPECT_LE(force.relative(), bar) << tree.name;
  EXPECT_LE(moment.relative(), bar) << tree.name;
}

TEST(Tree, OtherProgram) {
  const auto all = read_trees("trees");
  EXPECT_EQ(all.size(), 18u);
  for (const TreeFile& tree : all) {
    const Motion motion = tree.motion();
    const MotionSample& sample = motion.sample();
    // The oracle's own bar (README of the data).
    const double bar =
        tree.name.find("light_chain_heavy_tip") == std::string::npos ? 1e-11
                                                                     : 1e-10;
    compare_bodies(tree, sample, bar);
    const Matrix3d to_carrier = sample.carrier().rotation.transpose();
    Difference linear, angular;
    linear.add(to_carrier * sample.acceleration(0),
               vector_of(tree.expected["carrier_acceleration"]));
    angular.add(to_carrier * sample.angular_acceleration(0),
                vector_of(tree.expected["carrier_angular_acceleration"]));
    EXPECT_LE(linear.relative(), bar) << tree.name;
    EXPECT_LE(angular.relative(), bar) << tree.name;
  }
}

TEST(Tree, FrictionFitsTheReactions) {
  const auto all = read_trees("trees_friction");
  EXPECT_EQ(all.size(), 3u);
  for (const TreeFile& tree : all) {
    const Motion motion = tree.motion();
    ASSERT_FALSE(motion.failure()) << motion.failure()->message();
    const MotionSample& sample = motion.sample();
    // The two programs agree to 2e-11, so says the data's README.
    constexpr double bar = 1e-10;
    compare_bodies(tree, sample, bar);
    Difference friction;
    for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
      const json& e = tree.expected["bodies"][i];
      const HingeSample hinge = sample.hinge(static_cast<int>(i));
      friction.add(hinge.friction_moment,
                   vector_of(e["friction_moment_body_axes"]));
      if (!e.contains("utilisation")) continue;
      EXPECT_EQ(hinge.mode, HingeMode::resting);
      EXPECT_NEAR(hinge.utilisation, e["utilisation"].get<double>(), bar);
    }
    EXPECT_LE(friction.relative(), bar) << tree.name;
  }
}

std::string refused(const std::vector<Body>& bodies) {
  try {
    System({.fixed = true}, bodies);
  } catch (const contact::Error& e) {
    return e.what();
  }
  return "";
}

TEST(Tree, Refusals) {
  const auto hinged = [](int parent) {
    Body body{HingeKind::ball, 1, Matrix3d::Identity()};
    body.parent = parent;
    return body;
  };
  EXPECT_EQ(refused({hinged(1), hinged(-1)}), "");
  EXPECT_EQ(refused({hinged(2), hinged(0), hinged(1)}),
            "bodies[0] on bodies[2] on bodies[1] on bodies[0]: a circle");
  EXPECT_EQ(refused({hinged(0)}), "bodies[0] hangs on itself");
  EXPECT_EQ(refused({hinged(1)}),
            "bodies[0].parent = 1 must be one of the 1 bodies, or -1 for a "
            "root");
  Body alone = hinged(0);
  alone.kind = HingeKind::none;
  EXPECT_EQ(refused({hinged(-1), alone}),
            "bodies[1].parent must be -1 for a body without a hinge");
  Body thread = hinged(0);
  thread.inertia.setZero();
  thread.hinge_from_com = {1, 0, 0};
  EXPECT_EQ(
      refused({hinged(-1), thread}),
      "bodies[1].inertia_com must be above 0 about the line from the "
      "hinge to the centre of mass, where bodies hang on bodies or masses "
      "change");
}

// A star's masses are constants: a mass that changes would have no effect.
TEST(Tree, MassesChangeWhereBodiesSayThatTheyDo) {
  struct Burn : ForceModel {
    void add_forces(double, std::span<const BodyMotion>,
                    std::span<BodyForce>) const override {}
    void add_masses(double, std::vector<BodyMass>& to) const override {
      to.push_back({1, 2, Vector3d::Zero(), Matrix3d::Identity(), 0,
                    Vector3d::Zero(), Matrix3d::Zero()});
    }
  };
  Body body{HingeKind::ball, 1, Matrix3d::Identity()};
  body.hinge_from_com = {1, 0, 0};
  const auto motion = [&] {
    MotionStart start;
    start.bodies.resize(1);
    return Motion(System({10, Matrix3d::Identity()}, {body}), {},
                  std::make_shared<Burn>(), start, {});
  };
  try {
    motion();
    FAIL();
  } catch (const contact::Error& e) {
    EXPECT_EQ(std::string(e.what()),
              "bodies[0].flows, whose mass ForceModel::add_masses() changes, "
              "must be true");
  }
  body.flows = true;
  EXPECT_NO_THROW(motion());
}

}  // namespace
}  // namespace multibody::test::tree_test
