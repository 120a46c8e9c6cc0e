#pragma once

#include <span>

#include "libcontact/detail/cap_integrals.hpp"
#include "libcontact/friction_batch.hpp"
#include "libcontact/instruction_set.hpp"

namespace contact::detail {

/// The exact method's loops over nodes, compiled once per instruction set.
struct CapKernel {
  /// One point, lanes over nodes.
  CapSums<double> (*one)(const CapPoint<double>&, const CapRule&,
                         bool pole_inside, ArcRange);
  /// Many points, lanes over points; sizes already checked.
  void (*batch)(const FrictionBatchInput&, const FrictionBatchOutput&);
};

/// The kernel for a supported instruction set.
const CapKernel& cap_kernel(InstructionSet set);

}  // namespace contact::detail
