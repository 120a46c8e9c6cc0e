#pragma once

#include "angle/loads.hpp"
#include "angle/setup.hpp"
#include "cli/sweep.hpp"

namespace hinge_angle {

/// What is swept: a load in one of its variables, or the half-angle.
struct Input {
  LoadVariable variable;
  bool inverse;
  cli::Sweep values;
};

/// What the options sweep. Throws contact::Error if they do not fit together
/// or a value is not allowed.
Input make_input(const Options& options, const Setup& setup);

}  // namespace hinge_angle
