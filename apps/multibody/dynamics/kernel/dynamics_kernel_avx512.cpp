#include "libcontact/base/kernel_sets.hpp"
#ifdef CONTACT_AVX512_KERNELS
#include "libcontact/base/simd.hpp"
#include "multibody/dynamics/kernel/dynamics_kernel_impl.hpp"

namespace multibody::detail {

DynamicsKernel* new_dynamics_kernel_avx512(const SystemConstants& constants);
DynamicsKernel* new_dynamics_kernel_avx512(const SystemConstants& constants) {
  namespace stdx = std::experimental;
  // Few bodies: half of the registers' width, but all 32 of them.
  using Four = stdx::simd<double, stdx::simd_abi::deduce_t<double, 4>>;
  if (constants.size() <= 4) return new DynamicsKernelOf<Four>(constants);
  return new DynamicsKernelOf<stdx::native_simd<double>>(constants);
}

}  // namespace multibody::detail
#endif
