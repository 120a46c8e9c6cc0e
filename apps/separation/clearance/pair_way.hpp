// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <limits>
#include <span>

#include "multibody/system/force_model.hpp"
#include "separation/clearance/clearance.hpp"

namespace separation {

/// No point of b within a radius of its centre of mass is faster against a,
/// m/s.
double speed_bound(const multibody::BodyMotion& a,
                   const multibody::BodyMotion& b, double radius);

/// How near two bodies may be on their way, from a distance that was computed
/// and from how far they have moved against each other since.
class PairWay {
 public:
  /// @param radius  largest distance of a point of b's solids from its centre
  ///                of mass, m
  PairWay(Clearance::Pair pair, double radius) : pair_(pair), radius_(radius) {}

  /// Records a move; call at every evaluation.
  void move_on(double time, std::span<const multibody::BodyMotion> bodies);
  /// Records the computed present distance; NaN if it failed.
  void know(double distance);
  /// Call at a restart.
  void forget() { *this = PairWay(pair_, radius_); }

  /// Lower bound of the distance: the computed one minus the path of the point
  /// of b that has moved farthest. -infinity if nothing is known.
  double least_now() const { return now_; }
  /// Lower bound of the distance since the last evaluation, from the distances
  /// at both ends and the length of the path between them. The speeds at its
  /// ends, plus their difference, bound this length, because steps are smooth.
  double least_since() const { return (before_ + now_ - way_) / 2; }
  /// Time of the evaluation before the last one.
  double since() const { return since_; }

 private:
  static constexpr double unknown = -std::numeric_limits<double>::infinity();

  Clearance::Pair pair_;
  double radius_;
  // b in the axes of a: now, and at the computed distance.
  Eigen::Matrix3d rotation_ = Eigen::Matrix3d::Identity();
  Eigen::Vector3d place_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d known_rotation_ = Eigen::Matrix3d::Identity();
  Eigen::Vector3d known_place_ = Eigen::Vector3d::Zero();
  double known_ = unknown;
  double now_ = unknown;
  double before_ = unknown;
  double way_ = 0;
  double speed_ = 0;
  double time_ = 0;
  double since_ = 0;
};

}  // namespace separation
