#include "programs/separation/replay/gltf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "libcontact/version.hpp"

namespace separation {
namespace {

using Eigen::Vector3f;
using Json = Gltf::Json;

// glTF's colours are linear.
Json linear_colour(const std::string& colour, double alpha) {
  Json result = Json::array();
  for (const int at : {1, 3, 5}) {
    const double c = std::stoi(colour.substr(at, 2), nullptr, 16) / 255.0;
    result.push_back(c <= 0.04045 ? c / 12.92
                                  : std::pow((c + 0.055) / 1.055, 2.4));
  }
  result.push_back(alpha);
  return result;
}

}  // namespace

Gltf::Gltf(const Json& root) {
  json_["asset"] = {
      {"version", "2.0"},
      {"generator", fmt::format("hinge-separation {}", contact::version)}};
  json_["scene"] = 0;
  json_["scenes"].push_back(
      {{"name", root["name"]}, {"nodes", Json::array({0})}});
  json_["nodes"].push_back(root);
}

// Floats are little-endian in glTF, as on all machines that this runs on.
template <class Number>
int Gltf::add_view(const std::vector<Number>& numbers, int target) {
  Json view = {{"buffer", 0},
               {"byteOffset", data_.size()},
               {"byteLength", numbers.size() * sizeof(Number)}};
  if (target > 0) view["target"] = target;
  data_.append(reinterpret_cast<const char*>(numbers.data()),
               numbers.size() * sizeof(Number));
  json_["bufferViews"].push_back(std::move(view));
  return static_cast<int>(json_["bufferViews"].size()) - 1;
}

int Gltf::add_accessor(int view, int component, std::size_t count,
                       const char* type, const Json& more) {
  Json accessor = {{"bufferView", view},
                   {"componentType", component},
                   {"count", count},
                   {"type", type}};
  accessor.update(more);
  json_["accessors"].push_back(std::move(accessor));
  return static_cast<int>(json_["accessors"].size()) - 1;
}

int Gltf::add_floats(const std::vector<float>& values, const char* type,
                     int width, int target, bool range) {
  constexpr int float_type = 5126;
  Json more = Json::object();
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

int Gltf::add_vectors(const std::vector<Vector3f>& vectors, bool range) {
  constexpr int vertices = 34962;
  std::vector<float> values;
  for (const Vector3f& v : vectors) {
    values.insert(values.end(), v.begin(), v.end());
  }
  return add_floats(values, "VEC3", 3, vertices, range);
}

Json Gltf::add_solid(const Mesh& mesh) {
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
int Gltf::add_mesh(Json solid, const std::string& name,
                   const std::string& colour, double alpha) {
  Json material = {{"name", name},
                   {"pbrMetallicRoughness",
                    {{"baseColorFactor", linear_colour(colour, alpha)},
                     {"metallicFactor", 0.1},
                     {"roughnessFactor", 0.6}}}};
  if (alpha < 1) material["alphaMode"] = "BLEND";
  json_["materials"].push_back(std::move(material));
  solid["material"] = json_["materials"].size() - 1;
  json_["meshes"].push_back(
      {{"name", name}, {"primitives", Json::array({solid})}});
  return static_cast<int>(json_["meshes"].size()) - 1;
}

int Gltf::add_node(Json node) {
  json_["nodes"].push_back(std::move(node));
  return static_cast<int>(json_["nodes"].size()) - 1;
}

void Gltf::add_channel(int node, const char* path,
                       const std::vector<float>& times,
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

std::string Gltf::file() const {
  Json json = json_;
  if (!channels_.empty()) {
    json["animations"].push_back(
        {{"name", "motion"}, {"channels", channels_}, {"samplers", samplers_}});
  }
  json["buffers"].push_back({{"byteLength", data_.size()}});
  const auto whole = [](std::string bytes, char fill) {
    bytes.resize((bytes.size() + 3) / 4 * 4, fill);
    return bytes;
  };
  const std::string text =
      whole(json.dump(-1, ' ', false, Json::error_handler_t::replace), ' ');
  std::string result = "glTF";
  constexpr std::size_t heads = 12 + 8 + 8;
  const auto add = [&result](std::size_t number) {
    for (int shift = 0; shift < 32; shift += 8) {
      result += static_cast<char>(number >> shift & 0xff);
    }
  };
  add(2);
  add(heads + text.size() + data_.size());
  add(text.size());
  result += "JSON" + text;
  add(data_.size());
  result.append("BIN\0", 4);
  return result + data_;
}

}  // namespace separation
