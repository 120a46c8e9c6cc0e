#pragma once

/// The one door to <experimental/simd>: closed where its lanes compute wrongly.
#include <experimental/simd>

#include "libcontact/base/kernel_sets.hpp"

#if defined(__AVX512F__) && !defined(CONTACT_AVX512_KERNELS)
#error "lanes for AVX-512 require g++: -march must be without avx512f"
#endif
