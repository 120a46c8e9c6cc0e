#include "multibody/tracking/tracker_kernel_impl.hpp"

namespace multibody::detail {

extern const TrackerKernel tracker_kernel_avx2;
constinit const TrackerKernel tracker_kernel_avx2 = make_kernel();

}  // namespace multibody::detail
