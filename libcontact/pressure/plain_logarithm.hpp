#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "libcontact/pressure/expansion.hpp"

namespace contact::detail {

/// From x^3 ln x sum b_k x^(2k) to x^3 ln X sum b_k x^(2k), x and X as in
/// PressureExpansion with v = 1 + 2 c, c = cos(theta0/2): adds the difference
/// to the coefficients of x T_m(y), y = 2 x^2 - 1. It is x times x^2 sum b_k
/// x^(2k) times
///
///     ln(x/X) = ln((1 + w)/(2 w)) - sum r^m T_m(y)/m,  m = 1, 2, ...,
///     w = sqrt(c),  r = (1 - w)/(1 + w),
///
/// the T_m cut off where the coefficients end.
inline void to_plain_logarithm(double c, std::span<const double> b,
                               std::span<double> coefficient) {
  constexpr std::size_t most = PressureExpansion::max_terms;
  const std::size_t size = coefficient.size();
  const double w = std::sqrt(c);
  const double r = (1 - w) / (1 + w);
  std::array<double, most> log{std::log((1 + w) / (2 * w))};
  double power = 1;
  for (std::size_t m = 1; m < size; ++m) {
    static constexpr auto reciprocal = [] {
      std::array<double, most> values{};
      for (std::size_t i = 1; i < most; ++i) {
        values[i] = 1 / static_cast<double>(i);
      }
      return values;
    }();
    power *= r;
    log[m] = -power * reciprocal[m];
  }
  // Horner's rule in x^2 = (1 + y)/2, y T_m = (T_{m-1} + T_{m+1})/2.
  std::array<double, most + 2> sum{};  // coefficients of T_{m-1}
  for (auto factor = b.rbegin(); factor != b.rend(); ++factor) {
    std::array<double, most + 2> last{};
    for (std::size_t m = 0; m < most; ++m) {
      last[m + 1] = sum[m + 1] + *factor * log[m];
    }
    for (std::size_t m = 0; m < most; ++m) {
      sum[m + 1] = last[m + 1] / 2 + (last[m] + last[m + 2]) / 4;
    }
    sum[2] += last[1] / 4;  // y T_0 = T_1
  }
  for (std::size_t m = 0; m < size; ++m) coefficient[m] += sum[m + 1];
}

}  // namespace contact::detail
