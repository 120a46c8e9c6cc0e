#pragma once

#include <numbers>

#include "libcontact/base/simd.hpp"

namespace contact::detail {

/// ln x of positive normal numbers, within 2e-12; anything else gives some
/// finite number.
template <int n, LaneSet set>
[[gnu::always_inline]] inline LanesOf<n, set> logarithm(
    const LanesOf<n, set>& x) {
  using V = LanesOf<n, set>;
  // Mantissa, in [1/2, 1), and exponent by their bits: frexp is slow.
  const auto bits = x.bits();
  const V mantissa =
      V::of_bits((bits & 0x000fffffffffffffULL) | 0x3fe0000000000000ULL);
  // 2^52 plus the biased exponent is a double with the latter as its last bits.
  const V power = V::of_bits((bits >> 52) | 0x4330000000000000ULL) -
                  (4503599627370496.0 + 1022.0);
  // ln(m sqrt 2) = 2 artanh(t), |t| <= 0.172: the first term left out is 2e-13.
  constexpr double middle = std::numbers::sqrt2 / 2;
  const V t = (mantissa - middle) / (mantissa + middle);
  const V t2 = t * t;
  constexpr int last = 13;
  V sum = 2.0 / last;
#pragma GCC unroll 8
  for (int k = last - 2; k > 0; k -= 2) sum = sum * t2 + 2.0 / k;
  return sum * t + (power - 0.5) * std::numbers::ln2;
}

}  // namespace contact::detail
