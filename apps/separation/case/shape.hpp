// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

/// Stages, boosters and tanks as simple solids.
namespace separation {

enum class ShapeKind {
  capsule,   ///< cylinder with half balls at both ends
  cylinder,  ///< right circular, with flat ends
  cone,      ///< right circular, with a flat base
  hull,      ///< convex hull of points
};

/// A solid, body axes, m.
struct Shape {
  ShapeKind kind;
  /// Centres of the end balls (capsule) or end faces (cylinder); centre of the
  /// base and tip (cone). Not for a hull.
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  double radius = 0;
  /// Corners of the hull and its triangles, counter-clockwise from outside.
  std::vector<Eigen::Vector3d> points = {};
  std::vector<std::array<int, 3>> faces = {};
  std::string name = {};  ///< "": none

  void move(const Eigen::Vector3d& by);
};

/// No point of the solid is farther from the origin, m; of all of them.
double reach(const Shape& shape);
double reach(const std::vector<Shape>& shapes);

/// The convex hull of points; its corners are the extreme points.
/// @throws contact::Error if the points are fewer than 4 or (nearly) in one
///   plane
Shape convex_hull(const std::vector<Eigen::Vector3d>& points);

/// A box as the hull of its corners.
/// @param size      lengths of its edges, m
/// @param rotation  its axes, along the edges, to body axes
Shape box(const Eigen::Vector3d& centre, const Eigen::Vector3d& size,
          const Eigen::Matrix3d& rotation);

/// A solid of density 1 kg/m^3.
struct SolidProperties {
  double volume;             ///< m^3
  Eigen::Vector3d centroid;  ///< body axes, m
  Eigen::Matrix3d inertia;   ///< about the centroid, body axes, m^5
};

/// Exact formulas; relative error at most 1e-13 against integration over the
/// solid (separation/parts_test.cpp).
SolidProperties solid_properties(const Shape& shape);

/// Properties of several solids together; densities add up where they overlap.
SolidProperties solid_properties(const std::vector<Shape>& shapes);

}  // namespace separation
