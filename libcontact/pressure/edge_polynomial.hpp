#pragma once

#include <array>
#include <cstddef>

namespace contact::detail {

/// From a_k of sum_k a_k sin((2k+1) phi) to t_m of x sum_m t_m T_m(y),
/// x = sin(phi), y = 2 x^2 - 1.
template <std::size_t size>
std::array<double, size> edge_chebyshev(const std::array<double, size>& a) {
  // sin((2k+1) phi) = x (1 + 2 sum_{m=1}^k cos(2 m phi)),
  // cos(2 m phi) = (-1)^m T_m(y)
  std::array<double, size> t;
  double sum = 0;
  for (std::size_t m = size; m-- > 0;) {
    sum += a[m];
    t[m] = m % 2 != 0 ? -2 * sum : 2 * sum;
  }
  t[0] = sum;
  return t;
}

/// The parts of sum t_m T_m(y) that are even and odd in y, the latter over y,
/// as sums of T_m(T_2(y)).
template <std::size_t size>
std::array<std::array<double, size / 2>, 2> halves(
    const std::array<double, size>& t) {
  // T_{2m}(y) = T_m(T_2(y)), T_{2m+1}(y) = 2 y T_m(T_2(y)) - T_{2m-1}(y)
  std::array<std::array<double, size / 2>, 2> part;
  double next = 0;
  for (std::size_t m = size / 2; m-- > 0;) {
    part[0][m] = t[2 * m];
    part[1][m] = next = 2 * t[2 * m + 1] - next;
  }
  part[1][0] /= 2;
  return part;
}

/// From t_m of sum t_m T_m(T_4(y)) to powers of z = y^4 - y^2: T_4 = 1 + 8 z.
template <std::size_t size>
std::array<double, size> fourfold_powers(const std::array<double, size>& t) {
  std::array<double, size> sum{};
  std::array<double, size + 1> now{1};  // T_m
  std::array<double, size + 1> last{1, 8};
  for (std::size_t m = 0; m < size; ++m) {
    for (std::size_t j = 0; j <= m; ++j) sum[j] += t[m] * now[j];
    std::array<double, size + 1> next{};
    for (std::size_t j = 0; j <= m; ++j) {
      next[j] += 2 * now[j];
      next[j + 1] += 16 * now[j];
    }
    for (std::size_t j = 0; j <= m + 1; ++j) next[j] -= last[j];
    last = now;
    now = next;
  }
  return sum;
}

/// From t_m of sum_m t_m T_m(y) to c_k of PressureExpansion.
template <std::size_t size>
std::array<double, size> edge_polynomial(const std::array<double, size>& t) {
  std::array<double, size> c;
  const auto by_y = halves(t);
  for (std::size_t r = 0; r < 2; ++r) {
    const auto by_square = halves(by_y[r]);
    const auto even = fourfold_powers(by_square[0]);
    const auto odd = fourfold_powers(by_square[1]);
    // T_2 = 2 y^2 - 1
    for (std::size_t j = 0; j < size / 4; ++j) {
      c[4 * j + r] = even[j] - odd[j];
      c[4 * j + r + 2] = 2 * odd[j];
    }
  }
  return c;
}

}  // namespace contact::detail
