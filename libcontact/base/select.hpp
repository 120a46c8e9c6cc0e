#pragma once

#include "libcontact/base/simd.hpp"

/// One spelling of choices for double and for lane types.
namespace contact::detail {

template <class V>
struct MaskOf {
  using type = typename V::mask_type;
};
template <>
struct MaskOf<double> {
  using type = bool;
};
template <class V>
using mask_of = typename MaskOf<V>::type;

/// condition ? a : b
[[gnu::always_inline]] inline double select(bool condition, double a,
                                            double b) {
  return condition ? a : b;
}
template <class Abi>
[[gnu::always_inline]] inline std::experimental::simd<double, Abi> select(
    const std::experimental::simd_mask<double, Abi>& condition,
    const std::experimental::simd<double, Abi>& a,
    const std::experimental::simd<double, Abi>& b) {
  std::experimental::simd<double, Abi> result = b;
  where(condition, result) = a;
  return result;
}

[[gnu::always_inline]] inline bool any(bool condition) { return condition; }
template <class Abi>
[[gnu::always_inline]] inline bool any(
    const std::experimental::simd_mask<double, Abi>& condition) {
  return any_of(condition);
}

}  // namespace contact::detail
