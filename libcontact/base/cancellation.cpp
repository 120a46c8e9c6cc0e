#include "libcontact/base/cancellation.hpp"

#include <cmath>

namespace contact::detail {

// Both series alternate with falling terms; nested they read
// a_0 (1 - a_1 x^2 (1 - a_2 x^2 (...))). Below the switch the first term
// dominates, above it the difference has lost at most 2 bits.

double x_minus_sin_over_cube(double x) {
  const double y = x * x;
  if (y > 4) return (x - std::sin(x)) / (x * y);
  // Terms x^2k 6/(2k+3)!: 12 of them reach 1e-19 at x = 2.
  double sum = 1;
  for (int k = 12; k >= 1; --k) sum = 1 - y / ((2 * k + 2) * (2 * k + 3)) * sum;
  return sum / 6;
}

double sin_minus_x_cos_over_cube(double x) {
  const double y = x * x;
  if (y > 2) return (std::sin(x) - x * std::cos(x)) / (x * y);
  // Terms x^2k 3 (2k+2)/(2k+3)!: ratio y/(2k (2k+3)).
  double sum = 1;
  for (int k = 12; k >= 1; --k) sum = 1 - y / (2 * k * (2 * k + 3)) * sum;
  return sum / 3;
}

}  // namespace contact::detail
