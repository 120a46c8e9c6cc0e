#include "libcontact/base/simd.hpp"
#include "multibody/dynamics/kernel/forest_kernel_impl.hpp"

namespace multibody::detail {

ForestKernel forest_kernel_avx2();
ForestKernel forest_kernel_avx2() {
  return kernel_of<contact::detail::LanesOf<4>>();
}

}  // namespace multibody::detail
