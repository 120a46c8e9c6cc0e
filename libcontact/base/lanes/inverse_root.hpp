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

[[gnu::always_inline]] inline LanesOf<8> estimate(const LanesOf<8>& x) {
  return LanesOf<8>(_mm512_rsqrt14_pd(x.native()));
}
[[gnu::always_inline]] inline LanesOf<4> estimate(const LanesOf<4>& x) {
  return LanesOf<4>(_mm256_rsqrt14_pd(x.native()));
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
concept Any = std::is_same_v<V, LanesOf<8>> || std::is_same_v<V, LanesOf<4>>;

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
