// Few joints: half of the registers' width, but all 32 of them.
#define CONTACT_LANES 4
#include "libcontact/tracking/follower_kernel_impl.hpp"

namespace contact::detail {

extern const FollowerKernel follower_kernel_avx512_four;
constinit const FollowerKernel follower_kernel_avx512_four{
    predict, extend, approach, settle, largest, act, remember, extrapolate};

}  // namespace contact::detail
