// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "separation/clearance/solid.hpp"

namespace separation {

/// Position of a body in the axes of another body.
struct RelativePlace {
  Eigen::Matrix3d rotation;
  Eigen::Vector3d position;
};

/// Two points at which two solids are nearest to each other.
struct Nearest {
  /// m; 0 if the solids overlap or touch, infinity if they are farther apart
  /// than the limit, NaN if the distance could not be certified.
  double distance;
  /// The members below are in the axes of the first body, and defined only for
  /// a finite distance above 0. The normal of two planes that prove the
  /// distance, from the first solid to the second.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  /// Nearest point in each solid, m.
  Eigen::Vector3d on_a = Eigen::Vector3d::Zero();
  Eigen::Vector3d on_b = Eigen::Vector3d::Zero();
};

/// The distance of two solids, by the algorithm of Gilbert, Johnson and
/// Keerthi (libcontact/docs/reference/references.md#gilbert-1988).
///
/// It is certified: it is the distance of two points of the solids, and two
/// parallel planes between the solids have the same distance, to 1e-7 of the
/// size (the reaches of both and the distance of the bodies' origins). Solids
/// overlap if two of their points are that close and no plane separates them;
/// gaps of up to 1e-8 of the size may count as a touch.
///
/// Accuracy: 1e-9 m for boxes, prisms and other hulls of some metres, against
/// closed forms and against all pairs of corners, edges and faces; planes and
/// points agree to 1e-8 of the size for all pairs of kinds
/// (separation/clearance_test.cpp).
///
/// @param limit  the search ends as soon as the solids are known to be farther
///               apart than this, m
Nearest nearest(const Solid& a, const Solid& b, const RelativePlace& b_in_a,
                double limit);

}  // namespace separation
