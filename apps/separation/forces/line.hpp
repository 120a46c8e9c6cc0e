#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "separation/case/force_kind.hpp"
#include "separation/case/force_law.hpp"

namespace separation {

/// A force on one body and the opposite force on another along one line, which
/// conserves momentum.
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
  Eigen::Vector3d end;       ///< position of the end, m
  Eigen::Vector3d span;      ///< begin to end, m
  Eigen::Vector3d velocity;  ///< velocity of the end from the begin, m/s

  Line(const multibody::BodyMotion& from, const Eigen::Vector3d& from_point,
       const multibody::BodyMotion& to, const Eigen::Vector3d& to_point)
      : end(to.point(to_point)),
        span(end - from.point(from_point)),
        velocity(to.point_velocity(to_point) -
                 from.point_velocity(from_point)) {}
};

/// A force along the line between points of two bodies.
struct LineForce {
  Eigen::Vector3d point;
  int other = 0;                ///< rigid body
  Eigen::Vector3d other_point;  ///< from its centre of mass, its own axes

  ForceEnds where() const { return {point, other, other_point}; }
  Line line(const ForceInstant& at) const {
    return {at.bodies[other], other_point, at.on(), point};
  }
  /// Adds it and the opposite force; nothing if the points coincide.
  /// @param push  N, as a function of the length, m, and its rate, m/s;
  ///              positive: apart
  template <class Push>
  void add(const ForceInstant& at, std::span<multibody::BodyForce> forces,
           const Push& push) const {
    const Line l = line(at);
    const double length = l.span.norm();
    if (length == 0) return;
    const Eigen::Vector3d unit = l.span / length;
    add_opposite({at.body, other}, at.bodies, l.end,
                 push(length, unit.dot(l.velocity)) * unit, forces);
  }
  /// Length below which the direction is undefined: rounding of positions up to
  /// some 1e3 m.
  bool is_point(const ForceInstant& at) const {
    return line(at).span.norm() < 1e-12;
  }
};

/// The ends of a spring or a damper: `point` of its body, and `carrier_point`,
/// or `other_point` of `other_body`. Copies of one body and of another are
/// joined one by one.
LineForce read_line(const ForceTable& from);

}  // namespace separation
