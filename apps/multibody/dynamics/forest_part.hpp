#pragma once

#include "multibody/system/linear3.hpp"

/// Data of the kernels of a forest (kernel/forest_kernel.hpp): only numbers,
/// the same for all instruction sets.
namespace multibody {

/// Motion and loads of a body, its own axes.
struct ForestState {
  /// v_parent = rotation v_body; for a root v_inertial.
  Mat3<double> rotation{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  /// Relative to the parent, rad/s; for a root absolute. Held: not used.
  Vec3<double> angular_velocity{};
  Vec3<double> force{};   ///< without gravity, N
  Vec3<double> moment{};  ///< about the com, N m
  /// Moment of the hinge on the body about the hinge's centre, the opposite on
  /// the parent: M = hinge_moment + slope R, with the reaction R. On an axis
  /// only the component along the axis has an effect; held: none.
  Vec3<double> hinge_moment{};
  Mat3<double> slope{};  ///< dM/dR, m
  /// Accelerations of a fixed root, as in ForestMotion.
  Vec3<double> acceleration{};
  Vec3<double> angular_acceleration{};
};

namespace detail {

/// A vector padded for lanes of four.
struct alignas(32) Padded {
  double x = 0, y = 0, z = 0, none = 0;
};
struct PaddedMatrix {
  Padded x, y, z;  ///< columns
};

enum class ForestTurn { none, axis, ball };

/// Constants of a body in a mode of its hinge, in its own axes. The origin is
/// the centre of its hinge, for a root the centre of mass.
struct ForestHinge {
  int parent;  ///< -1: a root
  ForestTurn turn;
  double mass;
  Vec3<double> r;            ///< origin from ForestBody's 0
  Vec3<double> mass_r;       ///< m times that from the centre of mass
  Vec3<double> from_parent;  ///< origin from parent's com, its axes
  Vec3<double> axis;         ///< unit vector of the turn
  Mat3<double> inertia;      ///< about the origin
};

/// A body of a forest between the two steps, in the axes of its root. Including
/// its descendants,
///   R = a v' + b w' + force,   M = c v' + d w' + moment
/// act on it at the origin. The row e = T^T (-S, 1) of its hinge's law M = m +
/// S R eliminates the rotation.
struct alignas(32) ForestPart {
  PaddedMatrix rotation;  ///< from its own axes
  Padded r;               ///< origin from the centre of mass
  Padded from_parent;     ///< origin from the parent's origin
  Padded w;               ///< absolute angular velocity
  /// Accelerations if the parent has none and the hinge does not turn.
  Padded linear_bias, angular_bias;
  PaddedMatrix a, b, c, d;
  Padded own_force, own_moment;  ///< without the children
  Padded force, moment;
  PaddedMatrix slope;  ///< S, if required
  // Results of the elimination, y and the rows about the parent's origin. A
  // unit rotation requires the load x and y; the rows give the rotation caused
  // by motions of the parent.
  Padded axis, e;  ///< axis: T; -S^T T
  double inverse;  ///< axis: 1 over its own inertia
  Padded x_force, y_moment, row_force, row_moment;  ///< axis
  PaddedMatrix inverse_ball, x_ball, y_ball;        ///< ball
  PaddedMatrix row_ball, row_arm;                   ///< ball
  Padded given;                                     ///< ball: m
  double rate_change;                               ///< axis: q''
  Padded linear, angular, turn;                     ///< v', w', T q''
  Padded reaction, reaction_moment;
};

}  // namespace detail

[[gnu::always_inline]] inline detail::Padded padded(const Vec3<double>& v) {
  return {v.x, v.y, v.z};
}
[[gnu::always_inline]] inline Vec3<double> vec3(const detail::Padded& v) {
  return {v.x, v.y, v.z};
}
[[gnu::always_inline]] inline Mat3<double> mat3(const detail::PaddedMatrix& m) {
  return {vec3(m.x), vec3(m.y), vec3(m.z)};
}

}  // namespace multibody
