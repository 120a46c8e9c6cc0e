#include "libcontact/friction/kernel/cap_kernel.hpp"

namespace contact::detail {

extern const CapKernel cap_kernel_baseline;
extern const CapKernel cap_kernel_avx2;
extern const CapKernel cap_kernel_avx512;

const CapKernel& cap_kernel([[maybe_unused]] InstructionSet set) {
#ifdef __x86_64__
  if (set == InstructionSet::avx512) return cap_kernel_avx512;
  if (set == InstructionSet::avx2) return cap_kernel_avx2;
#endif
  return cap_kernel_baseline;
}

}  // namespace contact::detail
