#pragma once

#include <array>
#include <cstddef>

namespace contact::detail {

/// From a_k of sum_k a_k sin((2k+1) phi) to c_k of x sum_k c_k (2 x^2 - 1)^k,
/// x = sin(phi). Loses 2.4^size roundings of the last a_k: harmless for
/// coefficients that fall as those of pressures do.
template <std::size_t size>
std::array<double, size> edge_polynomial(const std::array<double, size>& a) {
  // f_k = sin((2k+1) phi)/sin(phi): f_{k+1} = -2 y f_k - f_{k-1},
  // y = 2 x^2 - 1, f_0 = 1, f_{-1} = -1.
  std::array<double, size> c{};
  std::array<double, size + 1> f{1};
  std::array<double, size + 1> last{-1};
  for (std::size_t k = 0; k < size; ++k) {
    for (std::size_t j = 0; j <= k; ++j) c[j] += a[k] * f[j];
    std::array<double, size + 1> next{};
    for (std::size_t j = 0; j <= k; ++j) next[j + 1] = -2 * f[j];
    for (std::size_t j = 0; j <= k; ++j) next[j] -= last[j];
    last = f;
    f = next;
  }
  return c;
}

}  // namespace contact::detail
