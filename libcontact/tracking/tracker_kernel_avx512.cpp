#ifdef __x86_64__
#include "libcontact/tracking/tracker_kernel_impl.hpp"

namespace contact::detail {

extern const TrackerKernel tracker_kernel_avx512;
constinit const TrackerKernel tracker_kernel_avx512 = make_kernel();

}  // namespace contact::detail
#endif
