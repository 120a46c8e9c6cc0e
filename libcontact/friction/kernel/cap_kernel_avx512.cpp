#ifdef __x86_64__
#include "libcontact/friction/kernel/cap_kernel_impl.hpp"

namespace contact::detail {

extern const CapKernel cap_kernel_avx512;
constinit const CapKernel cap_kernel_avx512{one, few, batch, root_pressure};

}  // namespace contact::detail
#endif
