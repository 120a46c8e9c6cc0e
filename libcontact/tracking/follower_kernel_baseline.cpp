#include "libcontact/tracking/follower_kernel_impl.hpp"

namespace contact::detail {

extern const FollowerKernel follower_kernel_baseline;
constinit const FollowerKernel follower_kernel_baseline{
    predict, extend, approach, settle, largest, act, remember, extrapolate};

}  // namespace contact::detail
