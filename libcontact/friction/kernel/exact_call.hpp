#pragma once

#include "libcontact/friction/integrals.hpp"
#include "libcontact/friction/kernel/cap_kernel.hpp"
#include "libcontact/friction/kernel/cap_point.hpp"

/// Parts common to the friction functions by the exact method and by other
/// pressures; in friction/exact.cpp.
namespace contact::detail {

/// The exact method for one point.
FrictionIntegrals exact_point(const CapKernel& kernel,
                              const PreparedCap<double>& cap);

/// Checks that a batch can be computed.
/// @throws Error if lengths differ, or as check_instruction_set().
void check_batch(const FrictionBatchInput& in, const FrictionBatchOutput& out);

}  // namespace contact::detail
