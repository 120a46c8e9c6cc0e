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

[[gnu::always_inline]] inline bool any(bool condition) { return condition; }
template <int n, LaneSet set>
[[gnu::always_inline]] inline bool any(const LaneMask<n, set>& condition) {
  return any_of(condition);
}

}  // namespace contact::detail
