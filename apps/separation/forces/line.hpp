#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "multibody/system/force_model.hpp"

namespace separation {

/// A force on one body and the opposite one on another along one line, so that
/// momentum is kept.
/// @param point  of the line, inertial axes
inline void add_opposite(std::array<int, 2> on,
                         std::span<const multibody::BodyMotion> bodies,
                         const Eigen::Vector3d& point,
                         const Eigen::Vector3d& force,
                         std::span<multibody::BodyForce> forces) {
  forces[on[0]].add_at(bodies[on[0]], point, force);
  forces[on[1]].add_at(bodies[on[1]], point, -force);
}

/// The line from a point of one body to a point of another, inertial axes.
struct Line {
  Eigen::Vector3d end;       ///< place of the latter, m
  Eigen::Vector3d span;      ///< to it, m
  Eigen::Vector3d velocity;  ///< of the end as seen from the begin, m/s

  Line(const multibody::BodyMotion& from, const Eigen::Vector3d& from_point,
       const multibody::BodyMotion& to, const Eigen::Vector3d& to_point)
      : end(to.point(to_point)),
        span(end - from.point(from_point)),
        velocity(to.point_velocity(to_point) -
                 from.point_velocity(from_point)) {}
};

}  // namespace separation
