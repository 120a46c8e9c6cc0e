#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "libcontact/base/lanes/select.hpp"
#include "libcontact/base/simd.hpp"

namespace contact::detail {

template <class V>
struct SineCosinePair {
  V sin, cos;
};

inline SineCosinePair<double> sine_cosine(double theta) {
  return {std::sin(theta), std::cos(theta)};
}

/// Sine and cosine of angles in [-pi/4, pi/4].
template <class V>
[[gnu::always_inline]] inline SineCosinePair<V> sine_cosine_series(const V& y) {
  // Taylor series: the first terms left out are 3e-19.
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
  return {V(sine * y), cosine};
}

/// Both functions of angles in [0, pi] at once; within 1e-16 of the larger leg,
/// relative error 2e-16 of sin at both ends. NaN gives NaN.
template <int n, LaneSet set>
[[gnu::always_inline]] inline SineCosinePair<LanesOf<n, set>> sine_cosine(
    const LanesOf<n, set>& theta) {
  using V = LanesOf<n, set>;
  constexpr double quarter = std::numbers::pi / 4;
  // pi/2 in two parts, the second its rounding error.
  constexpr double half_pi = std::numbers::pi / 2;
  constexpr double half_pi_rest = 6.123233995736766e-17;
  const auto middle = theta > quarter;
  const auto end = theta > 3 * quarter;
  const V turns = select(middle, V(1.0), V(0.0)) + select(end, V(1.0), V(0.0));
  const auto [sine, cosine] =
      sine_cosine_series(V((theta - turns * half_pi) - turns * half_pi_rest));
  return {select(end, V(-sine), select(middle, cosine, sine)),
          select(end, V(-cosine), select(middle, V(-sine), cosine))};
}

/// Both functions of any angle, by the scalar's own.
template <class T>
[[gnu::always_inline]] inline SineCosinePair<T> sine_cosine_of_any(
    const T& angle) {
  using std::cos, std::sin;
  return {sin(angle), cos(angle)};
}

/// Both functions of any angles at once, within 2e-16
/// (base/sine_cosine_test.cpp); beyond 1e5 by the standard library.
template <int n, LaneSet set>
[[gnu::always_inline]] inline SineCosinePair<LanesOf<n, set>>
sine_cosine_of_any(const LanesOf<n, set>& angle) {
  using V = LanesOf<n, set>;
  if (!all_of(abs(angle) <= 1e5)) {
    return {V([&](auto i) { return std::sin(angle[i]); }),
            V([&](auto i) { return std::cos(angle[i]); })};
  }
  // pi/2 in three parts, of 33 bits the first two: their products are exact.
  constexpr double first = 0x1.921fb544p+0;
  constexpr double second = 0x1.0b4611a6p-34;
  constexpr double third = 0x1.3198a2e037073p-69;
  // The sum's last bits are the number of quarter turns.
  constexpr double integers = 0x1.8p52;
  const V sum = angle * (2 / std::numbers::pi) + integers;
  const V turns = sum - integers;
  const auto [sine, cosine] = sine_cosine_series(
      V(((angle - turns * first) - turns * second) - turns * third));
  const auto is_set = [&](std::uint64_t bit) {
    return V::of_bits((sum.bits() & bit) | V(1.0).bits()) != V(1.0);
  };
  const auto odd = is_set(1);
  const auto half = is_set(2);
  const V s = select(odd, cosine, sine);
  const V c = select(odd, V(-sine), cosine);
  return {select(half, V(-s), s), select(half, V(-c), c)};
}

}  // namespace contact::detail
