#include "libcontact/base/simd.hpp"
#include "multibody/dynamics/kernel/dynamics_kernel_impl.hpp"

namespace multibody::detail {

DynamicsKernel* new_dynamics_kernel_avx2(const SystemConstants& constants);
DynamicsKernel* new_dynamics_kernel_avx2(const SystemConstants& constants) {
  using Lanes = contact::detail::LanesOf<4>;
  return new DynamicsKernelOf<Lanes>(constants);
}

}  // namespace multibody::detail
