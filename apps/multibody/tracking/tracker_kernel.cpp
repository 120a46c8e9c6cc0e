#include "multibody/tracking/tracker_kernel.hpp"

namespace multibody::detail {

extern const TrackerKernel tracker_kernel_baseline;
extern const TrackerKernel tracker_kernel_avx2;
extern const TrackerKernel tracker_kernel_avx512;
extern const TrackerKernel tracker_kernel_avx512_four;

const TrackerKernel& tracker_kernel([[maybe_unused]] InstructionSet set,
                                    [[maybe_unused]] int joints) {
#ifdef __x86_64__
  // Four lanes for four joints: 18 % of a friction evaluation.
  if (set == InstructionSet::avx512) {
    return joints <= 4 ? tracker_kernel_avx512_four : tracker_kernel_avx512;
  }
  if (set == InstructionSet::avx2) return tracker_kernel_avx2;
#endif
  return tracker_kernel_baseline;
}

}  // namespace multibody::detail
