#include "multibody/tracking/tracker_kernel_impl.hpp"

namespace multibody::detail {

extern const TrackerKernel tracker_kernel_baseline;
constinit const TrackerKernel tracker_kernel_baseline = make_kernel();

}  // namespace multibody::detail
