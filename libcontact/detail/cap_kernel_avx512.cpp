#include <immintrin.h>

#include <experimental/simd>

#include "libcontact/detail/cap_integrals.hpp"

namespace contact::detail {
namespace {

using Avx512Lanes = std::experimental::native_simd<double>;

/// The 14-bit estimate of AVX-512 and one step of fourth order: about one
/// unit in the last place, several times faster than root and division.
[[gnu::always_inline]] inline Avx512Lanes inverse_root(const Avx512Lanes& x) {
  const Avx512Lanes y(_mm512_rsqrt14_pd(static_cast<__m512d>(x)));
  const Avx512Lanes e = 1.0 - (x * y) * y;
  return y + (y * e) * (0.5 + e * (0.375 + e * 0.3125));
}

}  // namespace

template <>
[[gnu::always_inline]] inline InverseRoots<Avx512Lanes> inverse_roots(
    const Avx512Lanes& x, const Avx512Lanes& y) {
  return {inverse_root(x), inverse_root(y)};
}

}  // namespace contact::detail

#include "libcontact/detail/cap_kernel_impl.hpp"

namespace contact::detail {

extern const CapKernel cap_kernel_avx512;
constinit const CapKernel cap_kernel_avx512{one, few, batch, root_pressure};

}  // namespace contact::detail
