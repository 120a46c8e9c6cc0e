#include "programs/separation/replay/scene.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "libcontact/base/linear/turn.hpp"
#include "programs/separation/replay/gltf.hpp"
#include "programs/separation/replay/mesh.hpp"

namespace separation {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::Vector3f;
using multibody::HingeMode;
using nlohmann::ordered_json;

// Yellow comes last, because it is pale on white.
constexpr std::array colours = {"#d55e00", "#0072b2", "#009e73", "#e69f00",
                                "#56b4e9", "#cc79a7", "#f0e442"};
constexpr const char* grey = "#9a9a9a";

ordered_json numbers(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }
ordered_json numbers(const Quaterniond& q) {
  return {q.x(), q.y(), q.z(), q.w()};
}

// Largest distance of a body's solids from its centre of mass.
double reach_of(const RigidBody& body) {
  double reach = 0;
  for (const Shape& shape : body.shapes) {
    reach = std::max(reach, separation::reach(shape));
  }
  return reach;
}

// Adds bodies with their marks and motions to a glTF.
class Stage {
 public:
  Stage(const Case& c, double size, double tolerance)
      : case_(c),
        size_(size),
        tolerance_(tolerance),
        gltf_({{"name", c.name},
               {"rotation", numbers(contact::detail::turn_between(
                                upwards(c), Vector3d::UnitY()))}}) {
    add_marks();
  }

  // The numbers of its bodies' nodes.
  std::vector<int> add(const Take& take) {
    // Bodies of another case may have other shapes.
    if (solids_of_ != take.of) solids_.clear();
    solids_of_ = take.of;
    std::vector<int> nodes;
    for (int i = 0; i <= static_cast<int>(case_.bodies.size()); ++i) {
      nodes.push_back(add_body(take, i));
      gltf_.add_to_root(nodes.back());
    }
    return nodes;
  }

  std::string file() const { return gltf_.file(); }

 private:
  // Adds the marks of all hinges and of all locks.
  void add_marks() {
    const double r = 0.012 * size_;
    Mesh ball;
    ball.add({.kind = ShapeKind::capsule, .radius = r});
    Mesh cube;
    cube.add(box(Vector3d::Zero(), Vector3d::Constant(2 * r),
                 Eigen::Matrix3d::Identity()));
    const bool locks = std::ranges::any_of(
        case_.bodies, [](const Body& body) { return body.lock.has_value(); });
    if (case_.has_hinges())
      hinge_mesh_ =
          gltf_.add_mesh(gltf_.add_solid(ball), "hinge", "#202020", 1);
    if (locks)
      lock_mesh_ = gltf_.add_mesh(gltf_.add_solid(cube), "lock", "#b01010", 1);
  }

  // A body's shapes; takes of one case share them and differ in colour.
  Mesh mesh_of(const Case& c, int i) const {
    const RigidBody& body = c.rigid_body(i);
    Mesh mesh;
    for (const Shape& shape : body.shapes) mesh.add(shape);
    if (!body.shapes.empty()) return mesh;
    mesh = cross_mesh(0.3 * size_);
    if (i > 0 && !c.bodies[i - 1].hinge.body_point.isZero()) {
      mesh.add({.kind = ShapeKind::cylinder,
                .to = c.bodies[i - 1].hinge.body_point,
                .radius = 0.006 * size_});
    }
    return mesh;
  }

  int add_body(const Take& take, int i) {
    const std::string name = case_.rigid_body(i).name +
                             (take.name.empty() ? "" : " (" + take.name + ")");
    if (i == static_cast<int>(solids_.size())) {
      solids_.push_back(gltf_.add_solid(mesh_of(*take.of, i)));
    }
    const int mesh =
        gltf_.add_mesh(solids_[i], name, colour_of(i), take.faint ? 0.35 : 1);
    const BodyPath path(*take.of, *take.rows, take.kept, i);
    // Leaves a tenth of the tolerance to the motion between rows.
    const double most = 0.9 * tolerance_;
    const KeyFrames keys =
        key_frames(path, most * shown_position * size_, most * shown_turn);
    const Pose& first = keys.poses.front();
    ordered_json node = {{"name", name},
                         {"mesh", mesh},
                         {"translation", numbers(first.position)},
                         {"rotation", numbers(first.rotation)}};
    if (i > 0) {
      const Body& body = take.of->bodies[i - 1];
      if (hinge_mesh_ >= 0 && body.hinge.kind != multibody::HingeKind::none) {
        node["children"].push_back(
            add_mark(take, i, hinge_mesh_, name + ": " + body.hinge.name,
                     body.hinge.body_point, HingeMode::released));
      }
      if (body.lock) {
        node["children"].push_back(
            add_mark(take, i, lock_mesh_, name + ": " + body.lock->name,
                     body.lock->body_point, HingeMode::locked));
      }
    }
    const int number = gltf_.add_node(std::move(node));
    add_motion(number, keys);
    return number;
  }

  // Hidden from the first row with this mode or, for locked, without it.
  int add_mark(const Take& take, int i, int mesh, const std::string& name,
               const Vector3d& place, HingeMode mode) {
    const int node = gltf_.add_node(
        {{"name", name}, {"mesh", mesh}, {"translation", numbers(place)}});
    const std::size_t column =
        take.rows->column(column_name(case_.rigid_body(i).name) + ".mode");
    const auto start = static_cast<float>(take.rows->at(0, 0));
    for (const std::size_t row : take.kept) {
      const bool is = take.rows->at(row, column) == static_cast<double>(mode);
      const auto time = static_cast<float>(take.rows->at(row, 0));
      if (is == (mode == HingeMode::locked) || time <= start) continue;
      gltf_.add_channel(node, "scale", {start, time}, {1, 1, 1, 0, 0, 0},
                        "STEP");
      break;
    }
    return node;
  }

  void add_motion(int node, const KeyFrames& keys) {
    std::vector<float> times;
    std::vector<float> positions;
    std::vector<float> turns;
    Quaterniond before = keys.poses.front().rotation;
    for (std::size_t i = 0; i < keys.times.size(); ++i) {
      const auto time = static_cast<float>(keys.times[i]);
      if (i > 0 && time <= times.back()) continue;  // equal as floats
      times.push_back(time);
      const Pose& pose = keys.poses[i];
      const Vector3f p = pose.position.cast<float>();
      positions.insert(positions.end(), p.begin(), p.end());
      // Takes the nearer one of q and -q, which are the same rotation.
      Quaterniond q = pose.rotation;
      if (q.dot(before) < 0) q.coeffs() *= -1;
      before = q;
      for (const double x : q.coeffs()) turns.push_back(static_cast<float>(x));
    }
    const auto changes = [](const std::vector<float>& values, int width) {
      return !std::equal(values.begin() + width, values.end(), values.begin());
    };
    if (changes(positions, 3)) {
      gltf_.add_channel(node, "translation", times, positions, "LINEAR");
    }
    if (changes(turns, 4)) {
      gltf_.add_channel(node, "rotation", times, turns, "LINEAR");
    }
  }

  const Case& case_;
  double size_;
  double tolerance_;
  Gltf gltf_;
  std::vector<ordered_json> solids_;  // one for each body
  const Case* solids_of_ = nullptr;
  int hinge_mesh_ = -1;
  int lock_mesh_ = -1;
};

// Largest distance of bodies from the carrier's centre of mass in the first
// row.
double size_of(const Take& take) {
  const Case& c = *take.of;
  double size = 0;
  for (int i = 0; i <= static_cast<int>(c.bodies.size()); ++i) {
    const BodyPath path(c, *take.rows, take.kept, i);
    double reach = reach_of(c.rigid_body(i));
    if (i > 0) reach = std::max(reach, c.bodies[i - 1].hinge.body_point.norm());
    size = std::max(size, path.pose(0).position.norm() + reach);
  }
  return size > 0 ? size : 1;
}

}  // namespace

std::string colour_of(int body) {
  return body == 0 ? grey : colours[(body - 1) % colours.size()];
}

Vector3d upwards(const Case& c) {
  const Vector3d& g = c.options.gravity;
  return g.isZero() ? Vector3d::UnitZ() : Vector3d(-g.normalized());
}

std::vector<std::string> shapeless(const Case& c) {
  std::vector<std::string> names;
  for (int i = 0; i <= static_cast<int>(c.bodies.size()); ++i) {
    if (c.rigid_body(i).shapes.empty()) names.push_back(c.rigid_body(i).name);
  }
  return names;
}

Scene make_scene(const std::vector<Take>& takes, double tolerance) {
  Scene scene{{}, size_of(takes.front()), {}};
  Stage stage(*takes.front().of, scene.size, tolerance);
  for (const Take& take : takes) {
    const auto nodes = stage.add(take);
    if (scene.nodes.empty()) scene.nodes = nodes;
  }
  scene.glb = stage.file();
  return scene;
}

}  // namespace separation
