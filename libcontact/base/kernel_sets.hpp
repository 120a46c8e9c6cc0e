#pragma once

// The instruction sets that kernels of this build have beside the baseline.
// Comparisons and where() of lanes for AVX-512 are false in every lane when
// clang compiles the <experimental/simd> of libstdc++ 12 (clang 14 and 19): its
// builds do without.
#if defined(__x86_64__)
#define CONTACT_AVX2_KERNELS
#if !defined(__clang__)
#define CONTACT_AVX512_KERNELS
#endif
#endif
