// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "separation/case/shape.hpp"

namespace separation {

/// A convex solid of a body, described by its farthest points: everything
/// within margin() of a core.
class Solid {
 public:
  explicit Solid(const Shape& shape);

  /// The farthest point of the core along a direction of any length, body axes,
  /// m.
  Eigen::Vector3d farthest(const Eigen::Vector3d& direction) const;

  /// The radius of a capsule, whose core is its axis; else 0. m
  double margin() const { return margin_; }

  /// Largest distance of a point from the body's origin, m.
  double reach() const { return reach_; }

 private:
  ShapeKind kind_;
  Eigen::Vector3d from_;
  Eigen::Vector3d to_;
  Eigen::Matrix<double, 3, 2> across_;  // two directions of its ends
  double radius_;
  Eigen::Matrix3Xd points_;
  double margin_;
  double reach_;
};

}  // namespace separation
