#pragma once

#include "libcontact/joint/joint.hpp"
#include "libcontact/load_law/ball_formula.hpp"
#include "libcontact/load_law/load_law.hpp"

namespace contact::detail {

/// The largest coefficient that a ball's law is for.
double most_friction(const Joint& ball);

/// The one with the fewest numbers whose error is as wanted.
/// @throws Error for balls that it is not made for, and an error out of reach
BallLaw<double> ball_load_law(const Joint& ball, const LoadLawOptions& options);

}  // namespace contact::detail
