#include "libcontact/tracking/tracker_kernel_impl.hpp"

namespace contact::detail {

extern const TrackerKernel tracker_kernel_avx2;
constinit const TrackerKernel tracker_kernel_avx2 = make_kernel();

}  // namespace contact::detail
