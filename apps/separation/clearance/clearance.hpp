// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "multibody/system/force_model.hpp"
#include "separation/case/shape.hpp"
#include "separation/clearance/nearest.hpp"

namespace separation {

/// Smallest distances between moving bodies, certified and as accurate as
/// nearest() (separation/clearance_test.cpp).
class Clearance {
 public:
  /// Two bodies, numbered as in `shapes`, and which of their shapes; none: all.
  struct Pair {
    int a;
    int b;
    std::vector<int> a_shapes = {}, b_shapes = {};
  };

  /// @param shapes  of each body, from its centre of mass, body axes; may be
  ///                empty
  /// @param pairs   of bodies with shapes
  Clearance(const std::vector<std::vector<Shape>>& shapes,
            std::vector<Pair> pairs);

  const std::vector<Pair>& pairs() const { return pairs_; }

  /// Distance of one pair, m; 0 if they overlap or touch, NaN if it could not
  /// be certified.
  double distance(std::size_t pair,
                  std::span<const multibody::BodyMotion> bodies) const;

  /// A moving solid of a and one of b, in the axes of a.
  struct SolidLook {
    double time;
    double distance;  ///< as in distance()
    /// Speed of b's centre of mass relative to a, m/s, and rate of b, rad/s.
    Eigen::Vector3d velocity, turn;
    const Solid* solid;   ///< of b
    RelativePlace place;  ///< of b
    /// Of two planes that prove the distance, from a to b.
    Eigen::Vector3d normal;

    double radius() const { return solid->reach(); }
    double speed() const { return velocity.norm() + turn.norm() * radius(); }
  };
  /// Pairs of a solid of a and one of b.
  std::size_t solid_pairs(std::size_t pair) const;
  SolidLook look(std::size_t pair, std::size_t solids, double time,
                 const multibody::BodyMotion& a,
                 const multibody::BodyMotion& b) const;

  /// Nearest points of the two bodies of a pair, inertial axes, m; none if they
  /// overlap or the result is not certified.
  std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>> nearest_points(
      std::span<const multibody::BodyMotion> bodies, std::size_t pair) const;

 private:
  Nearest nearest_of(const Pair& pair,
                     std::span<const multibody::BodyMotion> bodies) const;

  std::vector<std::vector<Solid>> solids_;  // one list per body
  std::vector<Pair> pairs_;
};

}  // namespace separation
