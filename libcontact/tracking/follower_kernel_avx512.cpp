#include "libcontact/tracking/follower_kernel_impl.hpp"

namespace contact::detail {

extern const FollowerKernel follower_kernel_avx512;
constinit const FollowerKernel follower_kernel_avx512{
    predict, extend, approach, settle, largest, act, remember, extrapolate};

}  // namespace contact::detail
