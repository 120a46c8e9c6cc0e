#include "multibody/dynamics/kernel/lane_kernel_impl.hpp"

namespace multibody::detail {

LaneKernel* new_lane_kernel_avx512(const SystemConstants* const* constants,
                                   bool same_system);
LaneKernel* new_lane_kernel_avx512(const SystemConstants* const* constants,
                                   bool same_system) {
  return new_lane_kernel<Motions>(constants, same_system);
}

}  // namespace multibody::detail
