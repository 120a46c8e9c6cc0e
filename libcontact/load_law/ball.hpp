#pragma once

#include "libcontact/joint/joint.hpp"
#include "libcontact/load_law/ball_formula.hpp"
#include "libcontact/load_law/load_law.hpp"

namespace contact::detail {

/// The largest coefficient that a ball's law is for.
double most_friction(const Joint& ball);

/// The load law of a ball, and its errors as those of PinLoadLaw: of the vector
/// M, over |M|.
struct BallLoadLaw {
  BallLaw<double> law = {};
  double error = 0;
  double float_error = 0;
};

/// The one with the fewest numbers whose error is as wanted.
/// @throws Error for balls that it is not made for, and an error out of reach
BallLoadLaw ball_load_law(const Joint& ball, const LoadLawOptions& options);

}  // namespace contact::detail
