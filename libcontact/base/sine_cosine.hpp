#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "libcontact/base/select.hpp"
#include "libcontact/base/simd.hpp"

namespace contact::detail {

template <class V>
struct SineCosinePair {
  V sin, cos;
};

inline SineCosinePair<double> sine_cosine(double theta) {
  return {std::sin(theta), std::cos(theta)};
}

/// Both functions of angles in [0, pi] at once, in a third of the time of the
/// two calls of <experimental/simd>; within 1e-16 of the larger leg, relative
/// error 2e-16 of sin at both ends. NaN gives NaN.
template <class Abi>
[[gnu::always_inline]] inline SineCosinePair<
    std::experimental::simd<double, Abi>>
sine_cosine(const std::experimental::simd<double, Abi>& theta) {
  using V = std::experimental::simd<double, Abi>;
  constexpr double quarter = std::numbers::pi / 4;
  // pi/2 in two parts, the second its rounding error.
  constexpr double half_pi = std::numbers::pi / 2;
  constexpr double half_pi_rest = 6.123233995736766e-17;
  const auto middle = theta > quarter;
  const auto end = theta > 3 * quarter;
  const V turns = select(middle, V(1.0), V(0.0)) + select(end, V(1.0), V(0.0));
  const V y = (theta - turns * half_pi) - turns * half_pi_rest;
  // Taylor series on [-pi/4, pi/4]: the first terms left out are 3e-19.
  constexpr int last = 19;
  constexpr auto coefficient = [] {
    std::array<double, last + 1> c{1.0, 1.0};
    for (int k = 2; k <= last; ++k) c[k] = -c[k - 2] / (k * (k - 1.0));
    return c;
  }();
  const V y2 = y * y;
  V sine = coefficient[last];
  V cosine = coefficient[last - 1];
#pragma GCC unroll 16
  for (int k = last - 2; k > 0; k -= 2) {
    sine = sine * y2 + coefficient[k];
    cosine = cosine * y2 + coefficient[k - 1];
  }
  sine *= y;
  return {select(end, V(-sine), select(middle, cosine, sine)),
          select(end, V(-cosine), select(middle, V(-sine), cosine))};
}

}  // namespace contact::detail
