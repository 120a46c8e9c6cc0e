#include "libcontact/tracking/follower_kernel.hpp"

namespace contact::detail {

extern const FollowerKernel follower_kernel_baseline;
#if defined(__x86_64__)
extern const FollowerKernel follower_kernel_avx2;
extern const FollowerKernel follower_kernel_avx512;
extern const FollowerKernel follower_kernel_avx512_four;
#endif

const FollowerKernel& follower_kernel([[maybe_unused]] InstructionSet set,
                                      [[maybe_unused]] int joints) {
#if defined(__x86_64__)
  if (set == InstructionSet::avx512) {
    return joints <= 4 ? follower_kernel_avx512_four : follower_kernel_avx512;
  }
  if (set == InstructionSet::avx2) return follower_kernel_avx2;
#endif
  return follower_kernel_baseline;
}

}  // namespace contact::detail
