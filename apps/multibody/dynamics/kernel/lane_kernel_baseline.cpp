#include "multibody/dynamics/kernel/lane_kernel_impl.hpp"

namespace multibody::detail {

LaneKernel* new_lane_kernel_baseline(const SystemConstants* const* constants,
                                     bool same_system);
LaneKernel* new_lane_kernel_baseline(const SystemConstants* const* constants,
                                     bool same_system) {
  return new_lane_kernel<Motions>(constants, same_system);
}

int lanes_baseline();
int lanes_baseline() { return lane_count<Motions>(); }

}  // namespace multibody::detail
