#pragma once

#include <cstddef>
#include <optional>

#include "cli/sweep.hpp"
#include "programs/joint/setup.hpp"
#include "programs/joint/state.hpp"

namespace hinge_joint {

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

}  // namespace hinge_joint
