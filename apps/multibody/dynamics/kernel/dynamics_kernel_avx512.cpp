#ifdef __x86_64__
#include "libcontact/base/simd.hpp"
#include "multibody/dynamics/kernel/dynamics_kernel_impl.hpp"

namespace multibody::detail {

DynamicsKernel* new_dynamics_kernel_avx512(const SystemConstants& constants);
DynamicsKernel* new_dynamics_kernel_avx512(const SystemConstants& constants) {
  // Few bodies: half of the registers' width, but all 32 of them.
  using contact::detail::LanesOf;
  if (constants.size() <= 4) return new DynamicsKernelOf<LanesOf<4>>(constants);
  return new DynamicsKernelOf<LanesOf<8>>(constants);
}

}  // namespace multibody::detail
#endif
