#pragma once

#include "libcontact/joint/joint.hpp"
#include "libcontact/load_law/ball_formula.hpp"
#include "libcontact/load_law/load_law.hpp"

namespace contact::detail {

/// Largest coefficient of friction in a ball's law.
double most_friction(const Joint& ball);

/// The load law of a ball, with its errors: of the vector M, over |M|, in
/// double and float as in PinLoadLaw.
struct BallLoadLaw {
  BallLaw<double> law = {};
  double error = 0;
  double float_error = 0;
};

/// Finds the law with the fewest numbers that has the required error.
/// @throws Error for unsupported balls and for an unattainable error
BallLoadLaw ball_load_law(const Joint& ball, const LoadLawOptions& options);

}  // namespace contact::detail
