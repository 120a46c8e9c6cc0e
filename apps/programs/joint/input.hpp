#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>

#include "cli/sweep.hpp"
#include "programs/joint/setup.hpp"

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

/// The states that the options describe: a pair of vectors, or all pairs of
/// some forces and angles.
class Inputs {
 public:
  /// Throws contact::Error for options that do not fit together, or values
  /// that are not allowed.
  Inputs(const Options& options, bool pin);

  Question question() const { return question_; }
  std::size_t size() const {
    return forces_ ? angles_->size() * forces_->size() : 1;
  }
  Input operator[](std::size_t index) const;

  /// The sweeps, angles running fastest; none of vectors.
  const std::optional<cli::Sweep>& forces() const { return forces_; }
  const std::optional<cli::Sweep>& angles() const { return angles_; }
  /// The state for a pair of them.
  Input at(double force, double angle_deg) const;

 private:
  Question question_ = Question::reaction;
  Input vectors_ = {};
  std::optional<cli::Sweep> forces_;
  std::optional<cli::Sweep> angles_;
  double rate_ = 1;
};

/// R at the angle b from Dw: Dw along Z, R in the plane XOZ.
Input state_from_reaction(double reaction, double b_deg, double rate);
/// R_n n along Z, Dw in the plane YOZ at the angle a from Y, as in NOTATION.md.
Input state_from_contact(double normal_force, double a_deg, double rate);

}  // namespace hinge_joint
