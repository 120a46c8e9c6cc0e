// Few joints: half of the registers' width, but all 32 of them.
#ifdef __x86_64__
#define CONTACT_LANES 4
#include "multibody/tracking/tracker_kernel_impl.hpp"

namespace multibody::detail {

extern const TrackerKernel tracker_kernel_avx512_four;
constinit const TrackerKernel tracker_kernel_avx512_four = make_kernel();

}  // namespace multibody::detail
#endif
