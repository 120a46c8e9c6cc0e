#include "libcontact/tracking/tracker_kernel_impl.hpp"

namespace contact::detail {

extern const TrackerKernel tracker_kernel_baseline;
constinit const TrackerKernel tracker_kernel_baseline = make_kernel();

}  // namespace contact::detail
