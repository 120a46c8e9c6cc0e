#pragma once

#include <Eigen/Core>
#include <optional>

#include "libcontact/base/units.hpp"
#include "libcontact/joint/placement.hpp"

namespace hinge_joint {

/// Question asked of the joint.
enum class Question {
  reaction,  ///< friction under R and Dw
  contact,   ///< friction under R_n n and Dw
  rest,      ///< utilisation under R and M
};

/// One state of the joint; all vectors are in one frame.
struct Input {
  Eigen::Vector3d force;  ///< R, or R_n n; N
  Eigen::Vector3d turn;   ///< Dw, rad/s, or M, N m
  /// R or R_n, N, and b or a, degrees, as given, because values recomputed from
  /// the vectors differ in the last digits. Not used if vectors are given.
  struct Given {
    double force;
    double angle_deg;
  };
  std::optional<Given> given = {};
  /// Position of a finite-length pin, its axis along z; none if level.
  std::optional<contact::Placement> placement = {};
};

/// The state with R at the angle b from Dw: Dw along Z, R in the plane XOZ.
inline Input state_from_reaction(double reaction, double b_deg, double rate) {
  const auto [sin, cos] = contact::detail::sine_cosine_deg(b_deg);
  return {{reaction * sin, 0, reaction * cos},
          {0, 0, rate},
          Input::Given{reaction, b_deg}};
}
/// The state with R_n n along Z, and Dw in the plane YOZ at the angle a from Y,
/// as in docs/reference/notation.md.
inline Input state_from_contact(double normal_force, double a_deg,
                                double rate) {
  const auto [sin, cos] = contact::detail::sine_cosine_deg(a_deg);
  return {{0, 0, normal_force},
          {0, rate * cos, rate * sin},
          Input::Given{normal_force, a_deg}};
}

}  // namespace hinge_joint
