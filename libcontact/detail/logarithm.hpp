#pragma once

#include <experimental/simd>
#include <numbers>

namespace contact::detail {

/// ln x of positive normal numbers, within 2e-12; NaN gives NaN, 0 some
/// finite number.
template <class Abi>
[[gnu::always_inline]] inline std::experimental::simd<double, Abi> logarithm(
    const std::experimental::simd<double, Abi>& x) {
  using V = std::experimental::simd<double, Abi>;
  std::experimental::fixed_size_simd<int, V::size()> exponent;
  const V mantissa = frexp(x, &exponent);  // in [1/2, 1)
  // ln(m sqrt 2) = 2 artanh(t), |t| <= 0.172: the first term left out is 2e-13.
  constexpr double middle = std::numbers::sqrt2 / 2;
  const V t = (mantissa - middle) / (mantissa + middle);
  const V t2 = t * t;
  constexpr int last = 13;
  V sum = 2.0 / last;
#pragma GCC unroll 8
  for (int k = last - 2; k > 0; k -= 2) sum = sum * t2 + 2.0 / k;
  const V power = std::experimental::static_simd_cast<V>(exponent);
  return sum * t + (power - 0.5) * std::numbers::ln2;
}

}  // namespace contact::detail
