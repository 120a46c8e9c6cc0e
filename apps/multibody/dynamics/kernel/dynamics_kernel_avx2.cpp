#include "libcontact/base/simd.hpp"
#include "multibody/dynamics/kernel/dynamics_kernel_impl.hpp"

namespace multibody::detail {

DynamicsKernel* new_dynamics_kernel_avx2(const SystemConstants& constants);
DynamicsKernel* new_dynamics_kernel_avx2(const SystemConstants& constants) {
  using Lanes = std::experimental::native_simd<double>;
  return new DynamicsKernelOf<Lanes>(constants);
}

}  // namespace multibody::detail
