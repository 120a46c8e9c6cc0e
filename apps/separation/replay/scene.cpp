#include "separation/replay/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "libcontact/version.hpp"
#include "separation/replay/mesh.hpp"

namespace separation {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::Vector3f;
using multibody::HingeMode;
using nlohmann::ordered_json;

// Yellow comes last: on white it is pale.
constexpr std::array colours = {"#d55e00", "#0072b2", "#009e73", "#e69f00",
                                "#56b4e9", "#cc79a7", "#f0e442"};
constexpr const char* grey = "#9a9a9a";

// glTF's colours are linear.
ordered_json linear_colour(const std::string& colour, double alpha) {
  ordered_json result = ordered_json::array();
  for (const int at : {1, 3, 5}) {
    const double c = std::stoi(colour.substr(at, 2), nullptr, 16) / 255.0;
    result.push_back(c <= 0.04045 ? c / 12.92
                                  : std::pow((c + 0.055) / 1.055, 2.4));
  }
  result.push_back(alpha);
  return result;
}

ordered_json numbers(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }
ordered_json numbers(const Quaterniond& q) {
  return {q.x(), q.y(), q.z(), q.w()};
}

// How far the solids of a body reach from its centre of mass.
double reach_of(const RigidBody& body) {
  double reach = 0;
  for (const Shape& shape : body.shapes) {
    if (shape.kind != ShapeKind::hull) {
      reach = std::max({reach, shape.from.norm() + shape.radius,
                        shape.to.norm() + shape.radius});
    }
    for (const Vector3d& point : shape.points) {
      reach = std::max(reach, point.norm());
    }
  }
  return reach;
}

// Writes the parts of a glTF one by one: JSON that points into binary data.
class Writer {
 public:
  Writer(const Case& c, double size, double tolerance)
      : case_(c), size_(size), tolerance_(tolerance) {
    json_["asset"] = {
        {"version", "2.0"},
        {"generator", fmt::format("hinge-separation {}", contact::version)}};
    json_["scene"] = 0;
    json_["scenes"].push_back(
        {{"name", c.name}, {"nodes", ordered_json::array({0})}});
    const auto turn =
        Quaterniond::FromTwoVectors(upwards(c), Vector3d::UnitY());
    json_["nodes"].push_back({{"name", c.name}, {"rotation", numbers(turn)}});
    add_marks();
  }

  // The numbers of its bodies' nodes.
  std::vector<int> add(const Take& take) {
    std::vector<int> nodes;
    for (int i = 0; i <= static_cast<int>(case_.bodies.size()); ++i) {
      nodes.push_back(add_body(take, i));
      json_["nodes"][0]["children"].push_back(nodes.back());
    }
    return nodes;
  }

  std::string file() {
    if (!channels_.empty()) {
      json_["animations"].push_back({{"name", "motion"},
                                     {"channels", channels_},
                                     {"samplers", samplers_}});
    }
    json_["buffers"].push_back({{"byteLength", data_.size()}});
    const auto whole = [](std::string text, char fill) {
      text.resize((text.size() + 3) / 4 * 4, fill);
      return text;
    };
    const std::string json = whole(
        json_.dump(-1, ' ', false, ordered_json::error_handler_t::replace),
        ' ');
    std::string result = "glTF";
    constexpr std::size_t heads = 12 + 8 + 8;
    const auto add = [&result](std::size_t number) {
      for (int shift = 0; shift < 32; shift += 8) {
        result += static_cast<char>(number >> shift & 0xff);
      }
    };
    add(2);
    add(heads + json.size() + data_.size());
    add(json.size());
    result += "JSON" + json;
    add(data_.size());
    result.append("BIN\0", 4);
    return result + data_;
  }

 private:
  // Floats are little-endian in glTF, as on all machines that this runs on.
  template <class Number>
  int add_view(const std::vector<Number>& numbers, int target) {
    ordered_json view = {{"buffer", 0},
                         {"byteOffset", data_.size()},
                         {"byteLength", numbers.size() * sizeof(Number)}};
    if (target > 0) view["target"] = target;
    data_.append(reinterpret_cast<const char*>(numbers.data()),
                 numbers.size() * sizeof(Number));
    json_["bufferViews"].push_back(std::move(view));
    return static_cast<int>(json_["bufferViews"].size()) - 1;
  }

  int add_accessor(int view, int component, std::size_t count, const char* type,
                   const ordered_json& more = ordered_json::object()) {
    ordered_json accessor = {{"bufferView", view},
                             {"componentType", component},
                             {"count", count},
                             {"type", type}};
    accessor.update(more);
    json_["accessors"].push_back(std::move(accessor));
    return static_cast<int>(json_["accessors"].size()) - 1;
  }

  int add_floats(const std::vector<float>& values, const char* type, int width,
                 int target, bool range) {
    constexpr int float_type = 5126;
    ordered_json more = ordered_json::object();
    if (range) {
      for (int j = 0; j < width; ++j) {
        float low = values[j];
        float high = low;
        for (std::size_t i = j; i < values.size(); i += width) {
          low = std::min(low, values[i]);
          high = std::max(high, values[i]);
        }
        more["min"].push_back(low);
        more["max"].push_back(high);
      }
    }
    return add_accessor(add_view(values, target), float_type,
                        values.size() / width, type, more);
  }

  int add_vectors(const std::vector<Vector3f>& vectors, bool range) {
    constexpr int vertices = 34962;
    std::vector<float> values;
    for (const Vector3f& v : vectors) {
      values.insert(values.end(), v.begin(), v.end());
    }
    return add_floats(values, "VEC3", 3, vertices, range);
  }

  ordered_json add_solid(const Mesh& mesh) {
    constexpr int indices = 34963;
    constexpr int unsigned_int = 5125;
    return {
        {"attributes",
         {{"POSITION", add_vectors(mesh.positions, true)},
          {"NORMAL", add_vectors(mesh.normals, false)}}},
        {"indices", add_accessor(add_view(mesh.corners, indices), unsigned_int,
                                 mesh.corners.size(), "SCALAR")}};
  }

  // A solid with a colour of its own.
  int add_mesh(ordered_json solid, const std::string& name,
               const std::string& colour, double alpha) {
    ordered_json material = {
        {"name", name},
        {"pbrMetallicRoughness",
         {{"baseColorFactor", linear_colour(colour, alpha)},
          {"metallicFactor", 0.1},
          {"roughnessFactor", 0.6}}}};
    if (alpha < 1) material["alphaMode"] = "BLEND";
    json_["materials"].push_back(std::move(material));
    solid["material"] = json_["materials"].size() - 1;
    json_["meshes"].push_back(
        {{"name", name}, {"primitives", ordered_json::array({solid})}});
    return static_cast<int>(json_["meshes"].size()) - 1;
  }

  int add_node(ordered_json node) {
    json_["nodes"].push_back(std::move(node));
    return static_cast<int>(json_["nodes"].size()) - 1;
  }

  // Of all hinges and of all locks.
  void add_marks() {
    const double r = 0.012 * size_;
    Mesh ball;
    ball.add({.kind = ShapeKind::capsule, .radius = r});
    std::vector<Vector3d> corners;
    for (const double x : {-r, r}) {
      for (const double y : {-r, r}) {
        for (const double z : {-r, r}) corners.emplace_back(x, y, z);
      }
    }
    Mesh cube;
    cube.add(convex_hull(corners));
    const bool locks = std::ranges::any_of(
        case_.bodies, [](const Body& body) { return body.lock.has_value(); });
    if (case_.has_hinges())
      hinge_mesh_ = add_mesh(add_solid(ball), "hinge", "#202020", 1);
    if (locks) lock_mesh_ = add_mesh(add_solid(cube), "lock", "#b01010", 1);
  }

  // A body's shapes; the same for all takes but for the colour.
  Mesh mesh_of(int i) const {
    const RigidBody& body = case_.rigid_body(i);
    Mesh mesh;
    for (const Shape& shape : body.shapes) mesh.add(shape);
    if (!body.shapes.empty()) return mesh;
    mesh = cross_mesh(0.3 * size_);
    if (i > 0 && !case_.bodies[i - 1].hinge.body_point.isZero()) {
      mesh.add({.kind = ShapeKind::cylinder,
                .to = case_.bodies[i - 1].hinge.body_point,
                .radius = 0.006 * size_});
    }
    return mesh;
  }

  int add_body(const Take& take, int i) {
    const std::string name = case_.rigid_body(i).name +
                             (take.name.empty() ? "" : " (" + take.name + ")");
    if (i == static_cast<int>(solids_.size())) {
      solids_.push_back(add_solid(mesh_of(i)));
    }
    const int mesh =
        add_mesh(solids_[i], name, colour_of(i), take.faint ? 0.35 : 1);
    const BodyPath path(case_, *take.rows, take.kept, i);
    // Of what may be wrong a tenth is for what happens between the rows.
    const double most = 0.9 * tolerance_;
    const KeyFrames keys =
        key_frames(path, most * shown_position * size_, most * shown_turn);
    const Pose& first = keys.poses.front();
    ordered_json node = {{"name", name},
                         {"mesh", mesh},
                         {"translation", numbers(first.position)},
                         {"rotation", numbers(first.rotation)}};
    if (i > 0) {
      const Body& body = case_.bodies[i - 1];
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
    const int number = add_node(std::move(node));
    add_motion(number, keys);
    return number;
  }

  // Gone from the first row on with this mode, or (locked) without it.
  int add_mark(const Take& take, int i, int mesh, const std::string& name,
               const Vector3d& place, HingeMode mode) {
    const int node = add_node(
        {{"name", name}, {"mesh", mesh}, {"translation", numbers(place)}});
    const std::size_t column =
        take.rows->column(column_name(case_.rigid_body(i).name) + ".mode");
    const auto start = static_cast<float>(take.rows->at(0, 0));
    for (const std::size_t row : take.kept) {
      const bool is = take.rows->at(row, column) == static_cast<double>(mode);
      const auto time = static_cast<float>(take.rows->at(row, 0));
      if (is == (mode == HingeMode::locked) || time <= start) continue;
      add_channel(node, "scale", {start, time}, {1, 1, 1, 0, 0, 0}, "STEP");
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
      if (i > 0 && time <= times.back()) continue;  // the same to a float
      times.push_back(time);
      const Pose& pose = keys.poses[i];
      const Vector3f p = pose.position.cast<float>();
      positions.insert(positions.end(), p.begin(), p.end());
      // The nearer one of q and -q, which are the same turn.
      Quaterniond q = pose.rotation;
      if (q.dot(before) < 0) q.coeffs() *= -1;
      before = q;
      for (const double x : q.coeffs()) turns.push_back(static_cast<float>(x));
    }
    const auto changes = [](const std::vector<float>& values, int width) {
      return !std::equal(values.begin() + width, values.end(), values.begin());
    };
    if (changes(positions, 3)) {
      add_channel(node, "translation", times, positions, "LINEAR");
    }
    if (changes(turns, 4)) {
      add_channel(node, "rotation", times, turns, "LINEAR");
    }
  }

  void add_channel(int node, const char* path, const std::vector<float>& times,
                   const std::vector<float>& values,
                   const char* interpolation) {
    const bool turn = path == std::string_view("rotation");
    samplers_.push_back({{"input", add_floats(times, "SCALAR", 1, 0, true)},
                         {"output", add_floats(values, turn ? "VEC4" : "VEC3",
                                               turn ? 4 : 3, 0, false)},
                         {"interpolation", interpolation}});
    channels_.push_back({{"sampler", samplers_.size() - 1},
                         {"target", {{"node", node}, {"path", path}}}});
  }

  const Case& case_;
  double size_;
  double tolerance_;
  ordered_json json_;
  ordered_json channels_ = ordered_json::array();
  ordered_json samplers_ = ordered_json::array();
  std::string data_;
  std::vector<ordered_json> solids_;  // of bodies
  int hinge_mesh_ = -1;
  int lock_mesh_ = -1;
};

// How far from the carrier's centre of mass bodies reach in the first row.
double size_of(const Case& c, const Take& take) {
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

Scene make_scene(const Case& c, const std::vector<Take>& takes,
                 double tolerance) {
  Scene scene{{}, size_of(c, takes.front()), {}};
  Writer writer(c, scene.size, tolerance);
  for (const Take& take : takes) {
    const auto nodes = writer.add(take);
    if (scene.nodes.empty()) scene.nodes = nodes;
  }
  scene.glb = writer.file();
  return scene;
}

}  // namespace separation
