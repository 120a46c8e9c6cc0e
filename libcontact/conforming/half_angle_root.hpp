#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "libcontact/base/root_finding.hpp"
#include "libcontact/conforming/exact_results.hpp"
#include "libcontact/pair/inner_loading.hpp"

namespace contact::detail {

/// theta0 at which reciprocal_load(theta0) = 1/load parameter, for the exact
/// solutions: reciprocal_load decreases, and goes like 1/x^power as theta0
/// tends to 0 (power 2: pin, 3: ball), x ~ theta0 the variable of the
/// half-angle laws.
///
/// @param reciprocal  1/load parameter, [0, infinity)
/// @param x           that belongs to it; infinite for reciprocal = 0
/// @param largest     largest theta0 at which reciprocal_load may be called
/// @return not_converged with theta0 = largest if the root lies beyond it
template <class ReciprocalLoad>
ExactHalfAngle half_angle_root(const ReciprocalLoad& reciprocal_load,
                               double reciprocal, double x, int power,
                               double largest) {
  const double scale = std::min(x, 1.0);
  int evaluations = 0;
  // The last iterate is mostly ten times as close as its bracket is wide.
  double least = std::numeric_limits<double>::infinity();
  double nearest = largest;
  // Freed of its pole at 0 the difference is smooth and close to linear, near
  // 0 as well as near the limit angle.
  const auto residual = [&](double theta) {
    ++evaluations;
    const double rest = std::pow(std::tan(theta / 2) / scale, power) *
                        (reciprocal_load(theta) - reciprocal);
    if (std::abs(rest) < least) {
      least = std::abs(rest);
      nearest = theta;
    }
    return rest;
  };
  // In all elastic pairs theta0 > x/2 for x <= 1 and theta0 < 1.05 x for a
  // force at the centre; other loadings, walls and large x move the bracket.
  double low = scale / 2;
  double high = std::min({1.05 * x, 1.2, largest});
  double at_low = residual(low);
  double at_high = residual(high);
  // A wall may be much stiffer than its surface.
  for (int halvings = 0; at_low < 0 && halvings < 60; ++halvings) {
    high = low;
    at_high = at_low;
    low /= 2;
    at_low = residual(low);
  }
  while (!(at_high < 0) && high < largest) {
    low = high;
    at_low = at_high;
    high = std::min(1.15 * high, largest);
    at_high = residual(high);
  }
  if (!(at_low > 0 && at_high < 0)) {
    return {high, Status::not_converged, high - low, evaluations};
  }
  // 45 bits are 3e-14 of theta0, the rounding error of the solutions. Six to
  // nine steps; 60 is never reached.
  constexpr std::uintmax_t step_limit = 60;
  const RootBracket root =
      shrink_bracket(residual, low, high, at_low, at_high, 45, step_limit);
  return {nearest, root.converged ? Status::ok : Status::not_converged,
          root.high - root.low, evaluations};
}

}  // namespace contact::detail
