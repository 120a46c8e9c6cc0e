#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "programs/separation/replay/mesh.hpp"

namespace separation {

/// Builds a glTF 2.0 file: JSON that points into binary data. The functions
/// that add something return its index.
class Gltf {
 public:
  using Json = nlohmann::ordered_json;

  /// Makes node 0, the parent of all others.
  explicit Gltf(const Json& root);

  /// Adds triangles without a colour, which several meshes can share.
  Json add_solid(const Mesh& mesh);
  /// @param colour  "#rrggbb", sRGB
  /// @param alpha   1: opaque
  int add_mesh(Json solid, const std::string& name, const std::string& colour,
               double alpha);
  int add_node(Json node);
  /// Animates a node.
  /// @param path           "translation", "rotation" (x, y, z, w) or "scale"
  /// @param times          increasing, s
  /// @param values         3 or 4 for each time
  /// @param interpolation  "LINEAR" or "STEP"
  void add_channel(int node, const char* path, const std::vector<float>& times,
                   const std::vector<float>& values, const char* interpolation);
  void add_to_root(int node) { json_["nodes"][0]["children"].push_back(node); }

  /// The bytes of a .glb file.
  std::string file() const;

 private:
  template <class Number>
  int add_view(const std::vector<Number>& numbers, int target);
  int add_accessor(int view, int component, std::size_t count, const char* type,
                   const Json& more = Json::object());
  int add_floats(const std::vector<float>& values, const char* type, int width,
                 int target, bool range);
  int add_vectors(const std::vector<Eigen::Vector3f>& vectors, bool range);

  Json json_;
  Json channels_ = Json::array();
  Json samplers_ = Json::array();
  std::string data_;
};

}  // namespace separation
