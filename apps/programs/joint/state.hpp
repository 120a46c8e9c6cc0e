#pragma once

#include <Eigen/Core>
#include <optional>

namespace hinge_joint {

/// Kind of question to the joint.
enum class Question {
  reaction,  ///< friction under R and Dw
  contact,   ///< friction under R_n n and Dw
  rest,      ///< utilisation under R and M
};

/// One state of the joint, all vectors in one frame.
struct Input {
  Eigen::Vector3d force;  ///< R, or R_n n; N
  Eigen::Vector3d turn;   ///< Dw, rad/s, or M, N m
  /// R or R_n, N, and b or a, degrees, as they were given, for tables that say
  /// so again: what the vectors give differs in the last digits. Not of
  /// vectors.
  struct Given {
    double force;
    double angle_deg;
  };
  std::optional<Given> given = {};
};

/// R at the angle b from Dw: Dw along Z, R in the plane XOZ.
Input state_from_reaction(double reaction, double b_deg, double rate);
/// R_n n along Z, Dw in the plane YOZ at the angle a from Y, as in NOTATION.md.
Input state_from_contact(double normal_force, double a_deg, double rate);

}  // namespace hinge_joint
