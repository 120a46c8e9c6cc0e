#pragma once

#include "libcontact/detail/cap_integrals.hpp"
#include "libcontact/instruction_set.hpp"

namespace contact::detail {

/// Points that share a rule, the side of the pole and the arc range, picked
/// by `order` from arrays of points.
struct CapGroup {
  const CapPoint<double>* points;
  CapSums<double>* sums;
  const int* order;
  int count;
  const CapRule* rule;
  bool pole_inside;
  ArcRange range;
};

/// The exact method's loops over nodes, compiled once per instruction set.
struct CapKernel {
  /// One point, lanes over nodes.
  CapSums<double> (*one)(const CapPoint<double>&, const CapRule&,
                         bool pole_inside, ArcRange);
  /// Many points, lanes over points.
  void (*group)(const CapGroup&);
};

/// The kernel for a supported instruction set.
const CapKernel& cap_kernel(InstructionSet set);

}  // namespace contact::detail
