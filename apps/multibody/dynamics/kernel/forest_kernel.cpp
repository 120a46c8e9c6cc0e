#include "multibody/dynamics/kernel/forest_kernel.hpp"

namespace multibody::detail {

ForestKernel forest_kernel_baseline();
ForestKernel forest_kernel_avx2();

ForestKernel forest_kernel([[maybe_unused]] contact::InstructionSet set) {
#ifdef __x86_64__
  // Vectors of three have no use for wider lanes.
  if (set != contact::InstructionSet::baseline) return forest_kernel_avx2();
#endif
  return forest_kernel_baseline();
}

}  // namespace multibody::detail
