// Bodies on bodies at one instant: apps/multibody/dynamics/forest.hpp against
// another program, closed forms and a rigid body.
#include "multibody/dynamics/forest.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "libcontact/base/error.hpp"
#include "multibody/system/eigen_conversion.hpp"

namespace contact::test::forest_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using multibody::Forest;
using multibody::ForestBody;
using multibody::ForestMotion;
using multibody::ForestState;
using multibody::HingeKind;
using multibody::mat3;
using multibody::vec3;
using nlohmann::json;

Vector3d vector_of(const json& j) {
  return {j[0].get<double>(), j[1].get<double>(), j[2].get<double>()};
}

Matrix3d matrix_of(const json& j) {
  Matrix3d m;
  for (int i = 0; i < 3; ++i) m.row(i) = vector_of(j[i]);
  return m;
}

Matrix3d turn_of(const ForestState& state) {
  Matrix3d m;
  m << vec3(state.rotation.x), vec3(state.rotation.y), vec3(state.rotation.z);
  return m;
}

// The carrier is body 0, as in the files.
struct Tree {
  std::vector<ForestBody> bodies;
  std::vector<ForestState> state;
  Vector3d gravity;
  json expected;
  std::string name;
};

Tree read_tree(const std::filesystem::path& file) {
  std::ifstream stream(file);
  const json all = json::parse(stream);
  Tree tree;
  tree.gravity = vector_of(all["gravity_inertial"]);
  tree.expected = all["expected"];
  tree.name = file.filename().string();
  const json& c = all["carrier"];
  ForestBody carrier{.fixed = c.value("fixed", false)};
  if (!carrier.fixed) {
    carrier.mass = c["mass"];
    carrier.inertia = matrix_of(c["inertia_com"]);
  }
  tree.bodies.push_back(carrier);
  const auto vec = [](const json& j) { return vec3(vector_of(j)); };
  const auto mat = [](const json& j) { return mat3(matrix_of(j)); };
  tree.state.push_back({.rotation = mat(c["rotation_to_inertial"]),
                        .angular_velocity = vec(c["angular_velocity"]),
                        .force = vec(c["active_force"]),
                        .moment = vec(c["active_moment_com"])});
  for (const json& b : all["bodies"]) {
    const bool axis = b["kind"] == "axis";
    ForestBody body{
        .parent = b["parent"],
        .kind = axis ? HingeKind::axis : HingeKind::ball,
        .held = b["held"],
        .mass = b["mass"],
        .inertia = matrix_of(b["inertia_com"]),
        .hinge_from_com = vector_of(b["hinge_from_com"]),
        .hinge_from_parent_com = vector_of(b["hinge_from_parent_com"])};
    Vector3d friction = vector_of(b["friction_moment"]);
    if (axis) {
      const Matrix3d to_body = matrix_of(b["hinge_to_body"]);
      body.axis = to_body.col(2);
      friction = to_body * friction;
    }
    if (body.held) friction.setZero();
    tree.bodies.push_back(body);
    tree.state.push_back(
        {.rotation = mat(b["rotation_to_parent"]),
         .angular_velocity = vec(b["relative_angular_velocity"]),
         .force = vec(b["active_force"]),
         .moment = vec(b["active_moment_com"]),
         .hinge_moment = vec3(friction)});
  }
  return tree;
}

std::vector<Tree> trees() {
  std::vector<Tree> all;
  for (const auto& entry : std::filesystem::directory_iterator(
           CONTACT_DATA_DIR "/reference/trees")) {
    if (entry.path().extension() == ".json") {
      all.push_back(read_tree(entry.path()));
    }
  }
  return all;
}

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

double difference(const std::vector<ForestMotion>& a,
                  const std::vector<ForestMotion>& b) {
  Difference linear, angular, relative, force;
  for (std::size_t i = 0; i < b.size(); ++i) {
    linear.add(a[i].acceleration, b[i].acceleration);
    angular.add(a[i].angular_acceleration, b[i].angular_acceleration);
    relative.add(a[i].relative_acceleration, b[i].relative_acceleration);
    force.add(a[i].reaction, b[i].reaction);
  }
  return std::max({linear.relative(), angular.relative(), relative.relative(),
                   force.relative()});
}

TEST(Forest, OtherProgram) {
  const auto all = trees();
  EXPECT_EQ(all.size(), 18u);
  for (const Tree& t : all) {
    const auto motion = Forest(t.bodies).solve(t.state, t.gravity);
    Difference linear, angular, relative, force, moment;
    linear.add(motion[0].acceleration,
               vector_of(t.expected["carrier_acceleration"]));
    angular.add(motion[0].angular_acceleration,
                vector_of(t.expected["carrier_angular_acceleration"]));
    for (std::size_t i = 1; i < motion.size(); ++i) {
      const json& e = t.expected["bodies"][i - 1];
      const ForestMotion& m = motion[i];
      linear.add(m.acceleration, vector_of(e["acceleration_com"]));
      angular.add(m.angular_acceleration, vector_of(e["angular_acceleration"]));
      force.add(m.reaction, vector_of(e["reaction_force"]));
      const Vector3d given = vec3(t.state[i].hinge_moment);
      moment.add(m.reaction_moment - given, vector_of(e["reaction_moment"]));
      if (e.contains("relative_angular_acceleration")) {
        relative.add(m.relative_acceleration,
                     vector_of(e["relative_angular_acceleration"]));
      } else if (e.contains("angle_acceleration")) {
        relative.add(m.relative_acceleration,
                     t.bodies[i].axis * e["angle_acceleration"].get<double>());
      }
    }
    // Balls alone: the oracle's moments are the rounding of force times some
    // metre, ours are that too.
    if (moment.size < 1e-9 * force.size) moment.size = force.size;
    // The oracle's own bar (README of the data).
    const double bar = t.name.find("light_chain_heavy_tip") == std::string::npos
                           ? 1e-11
                           : 1e-10;
    EXPECT_LE(linear.relative(), bar) << t.name;
    EXPECT_LE(angular.relative(), bar) << t.name;
    EXPECT_LE(relative.relative(), bar) << t.name;
    EXPECT_LE(force.relative(), bar) << t.name;
    EXPECT_LE(moment.relative(), bar) << t.name;
  }
}

// Two thin rods, 1 m, 1 kg, horizontal, at rest on fixed ground: with absolute
// accelerations x, y about the hinges 4/3 x + y/2 = 3/2 g, x/2 + y/3 = g/2.
TEST(Forest, TwoRodsFromRest) {
  const double g = 9.81;
  ForestBody rod{.parent = 0,
                 .kind = HingeKind::axis,
                 .mass = 1,
                 .inertia = Vector3d(0, 1 / 12.0, 1 / 12.0).asDiagonal(),
                 .hinge_from_com = {-0.5, 0, 0},
                 .axis = Vector3d::UnitY()};
  ForestBody second = rod;
  second.parent = 1;
  second.hinge_from_parent_com = {0.5, 0, 0};
  const auto m = Forest({{.fixed = true}, rod, second})
                     .solve(std::vector<ForestState>(3), {0, 0, -g});
  // x = 9/7 g, y = -3/7 g. Reactions: 2/7 m g and -1/14 m g.
  EXPECT_NEAR(m[1].relative_acceleration.y(), 9 / 7.0 * g, 1e-13 * g);
  EXPECT_NEAR(m[2].relative_acceleration.y(), -12 / 7.0 * g, 1e-13 * g);
  EXPECT_NEAR(m[1].reaction.z(), 2 / 7.0 * g, 1e-13 * g);
  EXPECT_NEAR(m[2].reaction.z(), -1 / 14.0 * g, 1e-13 * g);
}

// All hinges held: one rigid body, whose mass, centre and inertia are summed.
TEST(Forest, HeldIsARigidBody) {
  int met = 0;
  for (Tree t : trees()) {
    if (t.bodies[0].fixed) continue;
    ++met;
    const std::size_t n = t.bodies.size();
    std::vector<Vector3d> at(n, Vector3d::Zero());
    std::vector<Matrix3d> turn(n, Matrix3d::Identity());
    double mass = 0;
    Vector3d centre = Vector3d::Zero();
    for (std::size_t i = 0; i < n; ++i) {
      ForestBody& b = t.bodies[i];
      if (i > 0) {
        b.held = true;
        turn[i] = turn[b.parent] * turn_of(t.state[i]);
        at[i] = at[b.parent] + turn[b.parent] * b.hinge_from_parent_com -
                turn[i] * b.hinge_from_com;
      }
      mass += b.mass;
      centre += b.mass * at[i];
    }
    centre /= mass;
    Matrix3d inertia = Matrix3d::Zero();
    Vector3d force = Vector3d::Zero();
    Vector3d moment = Vector3d::Zero();
    for (std::size_t i = 0; i < n; ++i) {
      const Vector3d d = at[i] - centre;
      inertia += turn[i] * t.bodies[i].inertia * turn[i].transpose() +
                 t.bodies[i].mass * (d.squaredNorm() * Matrix3d::Identity() -
                                     d * d.transpose());
      const Vector3d f = turn[i] * vec3(t.state[i].force);
      force += f;
      moment += turn[i] * vec3(t.state[i].moment) + d.cross(f);
    }
    const Vector3d w = vec3(t.state[0].angular_velocity);
    const Vector3d w_dot = inertia.ldlt().solve(moment - w.cross(inertia * w));
    const Vector3d g = turn_of(t.state[0]).transpose() * t.gravity;
    const auto m = Forest(t.bodies).solve(t.state, t.gravity);
    Difference linear, angular;
    for (std::size_t i = 0; i < n; ++i) {
      const Vector3d d = at[i] - centre;
      linear.add(turn[i] * m[i].acceleration,
                 force / mass + g + w_dot.cross(d) + w.cross(w.cross(d)));
      angular.add(turn[i] * m[i].angular_acceleration, w_dot);
    }
    // Rounding along chains of up to 32 bodies.
    EXPECT_LE(linear.relative(), 1e-13) << t.name;
    EXPECT_LE(angular.relative(), 1e-13) << t.name;
  }
  EXPECT_GE(met, 10);
}

// M = c + S R with c from the solution for M given: the same solution.
TEST(Forest, MomentsThatFollowReactions) {
  Matrix3d slope;
  slope << 1, 2, -1, 0.5, -1, 3, -2, 1, 0.7;
  for (Tree t : trees()) {
    const Forest forest(t.bodies);
    const auto given = forest.solve(t.state, t.gravity);
    for (std::size_t i = 1; i < t.bodies.size(); ++i) {
      // Some centimetres: a journal with much friction.
      const Matrix3d own = 0.02 / double(i) * slope;
      t.state[i].slope = mat3(own);
      t.state[i].hinge_moment -= vec3(Vector3d(own * given[i].reaction));
    }
    for (const auto set : contact::supported_instruction_sets()) {
      const auto found = Forest(t.bodies, set).solve(t.state, t.gravity);
      EXPECT_LE(difference(found, given), 1e-10) << t.name;
    }
  }
}

// A released body keeps no trace of its last hinge.
TEST(Forest, ReleasedHasNoReaction) {
  const Tree t = trees().front();
  Forest forest(t.bodies);
  multibody::ForestWork work;
  const int last = static_cast<int>(t.bodies.size()) - 1;
  for (const int parent : {t.bodies[last].parent, -1}) {
    forest.set_hinge(last, parent, false);
    forest.prepare(t.state, false, work);
    forest.respond(t.state, work);
    EXPECT_EQ(work.motion(last).reaction.isZero(0), parent < 0);
  }
  EXPECT_TRUE(work.motion(last).reaction_moment.isZero(0));
  EXPECT_TRUE(work.motion(last).relative_acceleration.isZero(0));
}

// The lanes of every instruction set, with and without slopes.
TEST(Forest, SetsAgree) {
  for (const Tree& t : trees()) {
    const auto all = [&](contact::InstructionSet set, bool sloped) {
      const Forest forest(t.bodies, set);
      multibody::ForestWork work;
      forest.prepare(t.state, sloped, work);
      forest.respond(t.state, work);
      std::vector<ForestMotion> to;
      for (std::size_t i = 0; i < t.bodies.size(); ++i) {
        to.push_back(work.motion(static_cast<int>(i)));
      }
      return to;
    };
    const auto plain = all(contact::InstructionSet::baseline, false);
    for (const auto set : contact::supported_instruction_sets()) {
      // Roundings, which light links multiply.
      for (const bool sloped : {false, true}) {
        EXPECT_LE(difference(all(set, sloped), plain), 1e-10) << t.name;
      }
    }
  }
}

TEST(Forest, AnyOrderAndSeveralRoots) {
  const auto all = trees();
  const Tree& t = all.front();
  const auto alone = Forest(t.bodies).solve(t.state, t.gravity);
  const int n = static_cast<int>(t.bodies.size());
  // The tree twice, children before parents.
  std::vector<ForestBody> bodies(2 * t.bodies.size());
  std::vector<ForestState> state(bodies.size());
  for (int copy = 0; copy < 2; ++copy) {
    for (int i = 0; i < n; ++i) {
      const int to = (copy + 1) * n - 1 - i;
      bodies[to] = t.bodies[i];
      state[to] = t.state[i];
      const int parent = t.bodies[i].parent;
      if (parent >= 0) bodies[to].parent = (copy + 1) * n - 1 - parent;
    }
  }
  const auto both = Forest(bodies).solve(state, t.gravity);
  for (int copy = 0; copy < 2; ++copy) {
    std::vector<ForestMotion> part;
    for (int i = 0; i < n; ++i) part.push_back(both[(copy + 1) * n - 1 - i]);
    EXPECT_EQ(difference(part, alone), 0);
  }
}

std::string refused(const std::vector<ForestBody>& bodies) {
  try {
    Forest forest(bodies);
  } catch (const contact::Error& e) {
    return e.what();
  }
  return "";
}

TEST(Forest, Refusals) {
  const auto hinged = [](int parent) {
    return ForestBody{.parent = parent, .kind = HingeKind::ball, .mass = 1};
  };
  const ForestBody root{.fixed = true};
  EXPECT_EQ(refused({root, hinged(0)}), "");
  EXPECT_EQ(refused({root, hinged(3), hinged(1), hinged(2)}),
            "bodies[3] on bodies[2] on bodies[1] on bodies[3]: a circle");
  EXPECT_EQ(refused({root, hinged(1)}), "bodies[1] hangs on itself");
  EXPECT_EQ(refused({root, hinged(7)}),
            "bodies[1].parent = 7 must be one of the 2 bodies, or -1 for a "
            "root");
  ForestBody bad = hinged(0);
  bad.mass = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refused({root, bad}),
            "bodies[1].mass = nan kg must be above 0 and finite");
  bad = hinged(0);
  bad.axis *= 2;
  EXPECT_EQ(refused({root, bad}),
            "bodies[1].axis has the length 2, it must be 1");
  EXPECT_THROW(Forest({root}).solve({}, Vector3d::Zero()), contact::Error);
}

}  // namespace
}  // namespace contact::test::forest_test
