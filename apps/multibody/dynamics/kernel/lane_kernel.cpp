#include "multibody/dynamics/kernel/lane_kernel.hpp"

namespace multibody::detail {

using contact::InstructionSet;

LaneKernel* new_lane_kernel_baseline(const SystemConstants* const* constants,
                                     bool same_system);
int lanes_baseline();
#if defined(__x86_64__)
LaneKernel* new_lane_kernel_avx2(const SystemConstants* const* constants,
                                 bool same_system);
LaneKernel* new_lane_kernel_avx512(const SystemConstants* const* constants,
                                   bool same_system);
#endif

std::unique_ptr<LaneKernel> make_lane_kernel(
    const SystemConstants* const* constants, bool same_system,
    [[maybe_unused]] InstructionSet set) {
  LaneKernel* kernel = nullptr;
#if defined(__x86_64__)
  if (set == InstructionSet::avx2) {
    kernel = new_lane_kernel_avx2(constants, same_system);
  }
  if (set == InstructionSet::avx512) {
    kernel = new_lane_kernel_avx512(constants, same_system);
  }
#endif
  if (!kernel) kernel = new_lane_kernel_baseline(constants, same_system);
  return std::unique_ptr<LaneKernel>(kernel);
}

int lane_width(InstructionSet set) {
  return set == InstructionSet::avx512 ? 8
         : set == InstructionSet::avx2 ? 4
                                       : lanes_baseline();
}

}  // namespace multibody::detail
