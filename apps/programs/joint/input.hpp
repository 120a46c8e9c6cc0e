#pragma once

#include <cmath>
#include <cstddef>
#include <optional>

#include "cli/sweep.hpp"
#include "programs/joint/setup.hpp"
#include "programs/joint/state.hpp"

namespace hinge_joint {

/// The states that the options describe: a pair of vectors, or all combinations
/// of forces, angles and rates, or of forces and tilts.
class Inputs {
 public:
  /// Throws contact::Error for options that conflict and values that are not
  /// allowed.
  Inputs(const Options& options, const Setup& setup);

  Question question() const { return question_; }
  std::size_t size() const {
    return forces_ ? angles_->size() * forces_->size() * rates_->size() * lies()
                   : 1;
  }
  Input operator[](std::size_t index) const;

  /// True if the load's place along a pin is given.
  bool is_placed() const {
    return placements_ && !std::isnan((*placements_)[0].place);
  }

  /// The sweeps; angles vary fastest. None for vectors.
  const std::optional<cli::Sweep>& forces() const { return forces_; }
  const std::optional<cli::Sweep>& angles() const { return angles_; }
  /// Rates, rad/s; they vary faster than the angles.
  const std::optional<cli::Sweep>& rates() const { return rates_; }
  /// The state with these three numbers.
  Input at(double force, double angle_deg, double rate) const;

 private:
  std::size_t lies() const { return placements_ ? placements_->size() : 1; }

  Question question_ = Question::reaction;
  Input vectors_ = {};
  std::optional<cli::Sweep> forces_;
  std::optional<cli::Sweep> angles_;
  /// Vary faster than the rates.
  std::optional<cli::Placements> placements_;
  double slide_ = 0;
  std::optional<cli::Sweep> rates_;
};

/// --rate, rad/s; 1 by default.
cli::Sweep rates_of(const Options& options);
/// The only rate; throws contact::Error for several.
double only_rate(const Options& options);

}  // namespace hinge_joint
