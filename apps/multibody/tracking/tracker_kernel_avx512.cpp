#ifdef __x86_64__
#include "multibody/tracking/tracker_kernel_impl.hpp"

namespace multibody::detail {

extern const TrackerKernel tracker_kernel_avx512;
constinit const TrackerKernel tracker_kernel_avx512 = make_kernel();

}  // namespace multibody::detail
#endif
