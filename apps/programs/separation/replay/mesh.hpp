#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "separation/case/shape.hpp"

namespace separation {

/// Triangles, counter-clockwise from outside, with a normal at each corner.
struct Mesh {
  std::vector<Eigen::Vector3f> positions;  ///< m
  std::vector<Eigen::Vector3f> normals;    ///< unit
  std::vector<std::uint32_t> corners;      ///< three for each triangle

  /// Round solids get enough sides to be within 0.3 % of their radius.
  void add(const Shape& shape);
};

/// A cross of three bars of this length about the origin, for a body without
/// shapes.
Mesh cross_mesh(double length);

}  // namespace separation
