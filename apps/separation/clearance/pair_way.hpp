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
  /// @param radius  of b about its centre of mass: no point of its solids is
  ///                farther away, m
  PairWay(Clearance::Pair pair, double radius) : pair_(pair), radius_(radius) {}

  /// They have moved on: call it at every look.
  void move_on(double time, std::span<const multibody::BodyMotion> bodies);
  /// Their distance now was computed; NaN if it was not found.
  void know(double distance);
  /// At a new beginning.
  void forget() { *this = PairWay(pair_, radius_); }

  /// The distance is at least this: the one that was computed, less the way of
  /// the point of b that has moved farthest. -infinity if nothing is known.
  double least_now() const { return now_; }
  /// Nowhere since the last look was it less: between two distances that are
  /// the length of a way apart. How long the way is follows from the speeds at
  /// its ends, and as much more as these differ: steps are smooth.
  double least_since() const { return (before_ + now_ - way_) / 2; }
  /// The time of the last look but this.
  double since() const { return since_; }

 private:
  static constexpr double unknown = -std::numeric_limits<double>::infinity();

  Clearance::Pair pair_;
  double radius_;
  // b in the axes of a: now, and where the distance was computed.
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
