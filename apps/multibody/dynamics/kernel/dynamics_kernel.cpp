#include "multibody/dynamics/kernel/dynamics_kernel.hpp"

namespace multibody::detail {

DynamicsKernel* new_dynamics_kernel_baseline(const SystemConstants& constants);
DynamicsKernel* new_dynamics_kernel_avx2(const SystemConstants& constants);
DynamicsKernel* new_dynamics_kernel_avx512(const SystemConstants& constants);

std::unique_ptr<DynamicsKernel> make_dynamics_kernel(
    const SystemConstants& constants,
    [[maybe_unused]] contact::InstructionSet set) {
  DynamicsKernel* kernel = nullptr;
#ifdef __x86_64__
  if (set == contact::InstructionSet::avx2) {
    kernel = new_dynamics_kernel_avx2(constants);
  }
  if (set == contact::InstructionSet::avx512) {
    kernel = new_dynamics_kernel_avx512(constants);
  }
#endif
  if (!kernel) kernel = new_dynamics_kernel_baseline(constants);
  return std::unique_ptr<DynamicsKernel>(kernel);
}

}  // namespace multibody::detail
