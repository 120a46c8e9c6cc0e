#include "multibody/dynamics/kernel/dynamics_kernel_impl.hpp"

namespace multibody::detail {

DynamicsKernel* new_dynamics_kernel_baseline(const SystemConstants& constants);
DynamicsKernel* new_dynamics_kernel_baseline(const SystemConstants& constants) {
  using Lanes = double;
  return new DynamicsKernelOf<Lanes>(constants);
}

}  // namespace multibody::detail
