#pragma once

#include <cmath>

#ifdef __AVX512VL__
#include <immintrin.h>

#include <type_traits>

#include "libcontact/base/simd.hpp"
#endif

/// 1/sqrt(x) for double and lane types, to two units in the last place, of two
/// numbers at once to three (base/inverse_root_test.cpp); x > 0.
namespace contact::detail {

template <class V>
[[gnu::always_inline]] inline V inverse_root(const V& x) {
  using std::sqrt;
  return 1.0 / sqrt(x);
}

/// Inverse roots of two numbers at once, for one division.
template <class V>
struct InverseRoots {
  V first, second;
};
template <class V>
[[gnu::always_inline]] inline InverseRoots<V> inverse_roots(const V& x,
                                                            const V& y) {
  using std::sqrt;
  const V root_x = sqrt(x);
  const V root_y = sqrt(y);
  const V inverse = 1.0 / (root_x * root_y);
  return {inverse * root_y, inverse * root_x};
}
/// sqrt(x), where 1/sqrt(x) is known as `inverse`.
template <class V>
[[gnu::always_inline]] inline V root(const V& x, const V&) {
  using std::sqrt;
  return sqrt(x);
}

#ifdef __AVX512VL__
namespace avx512 {

template <int size>
using Lanes = std::experimental::simd<
    double, std::experimental::simd_abi::deduce_t<double, size>>;

// Lanes here are types that files for other instruction sets do not have.
static_assert(
    !std::is_same_v<Lanes<4>,
                    std::experimental::simd<
                        double, std::experimental::simd_abi::_VecBuiltin<32>>>);

[[gnu::always_inline]] inline Lanes<8> estimate(const Lanes<8>& x) {
  return Lanes<8>(_mm512_rsqrt14_pd(static_cast<__m512d>(x)));
}
[[gnu::always_inline]] inline Lanes<4> estimate(const Lanes<4>& x) {
  return Lanes<4>(_mm256_rsqrt14_pd(static_cast<__m256d>(x)));
}

/// The 14-bit estimate and one step of fourth order: several times faster than
/// root and division.
template <class V>
[[gnu::always_inline]] inline V refined(const V& x) {
  const V y = estimate(x);
  const V e = 1.0 - (x * y) * y;
  return y + (y * e) * (0.5 + e * (0.375 + e * 0.3125));
}

template <class V>
concept Any = std::is_same_v<V, Lanes<8>> || std::is_same_v<V, Lanes<4>>;

}  // namespace avx512

template <avx512::Any V>
[[gnu::always_inline]] inline V inverse_root(const V& x) {
  return avx512::refined(x);
}
template <avx512::Any V>
[[gnu::always_inline]] inline InverseRoots<V> inverse_roots(const V& x,
                                                            const V& y) {
  return {inverse_root(x), inverse_root(y)};
}
template <avx512::Any V>
[[gnu::always_inline]] inline V root(const V& x, const V& inverse) {
  return x * inverse;
}
#endif

}  // namespace contact::detail
