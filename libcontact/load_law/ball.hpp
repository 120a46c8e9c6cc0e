#pragma once

#include "libcontact/joint/joint.hpp"
#include "libcontact/load_law/ball_formula.hpp"
#include "libcontact/load_law/load_law.hpp"

namespace contact::detail {

/// Largest coefficient of friction in a ball's law.
double most_friction(const Joint& ball);

/// Finds the law with the fewest numbers that has the required error.
/// @throws Error for unsupported balls and for an unattainable error
BallLaw<double> ball_load_law(const Joint& ball, const LoadLawOptions& options);

}  // namespace contact::detail
