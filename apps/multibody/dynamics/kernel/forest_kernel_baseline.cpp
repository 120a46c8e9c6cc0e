#include "multibody/dynamics/kernel/forest_kernel_impl.hpp"

namespace multibody::detail {

ForestKernel forest_kernel_baseline();
ForestKernel forest_kernel_baseline() { return kernel_of<Vec3<double>>(); }

}  // namespace multibody::detail
