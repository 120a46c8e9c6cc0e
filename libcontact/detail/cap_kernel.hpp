#pragma once

#include <span>

#include "libcontact/detail/cap_integrals.hpp"
#include "libcontact/friction_batch.hpp"
#include "libcontact/instruction_set.hpp"

namespace contact::detail {

/// Concentric contacts under one slip axis, all on the same side of the pole,
/// with a weight for each. Sizes are multiples of CapRule::lanes; neighbours
/// should be alike.
struct CapStack {
  int size;
  const double* sine;    ///< of the half-angle, >= 0
  const double* cosine;  ///< of the half-angle
  const double* weight;
  bool pole_inside;  ///< sine >= cosine of the slip axis angle
};

/// The exact method's loops over nodes, compiled once per instruction set.
struct CapKernel {
  /// One point, lanes over nodes.
  CapSums<double> (*one)(const CapPoint<double>&, const CapRule&,
                         bool pole_inside, ArcRange);
  /// Many points, lanes over points; sizes already checked.
  void (*batch)(const FrictionBatchInput&, const FrictionBatchOutput&);
  /// Weighted sum of the area integrals of a stack, lanes over contacts.
  AreaSums<double> (*areas)(const CapStack&, double axis_sin, double axis_cos);
  /// The integrals of a pressure x sum_k c_k (2 x^2 - 1)^k, x the edge
  /// variable, over a contact of at most 90 degrees, lanes along the arcs.
  AreaSums<double> (*root_pressure)(const CapPoint<double>&, bool pole_inside,
                                    std::span<const double> coefficients);
};

/// The kernel for a supported instruction set.
const CapKernel& cap_kernel(InstructionSet set);

}  // namespace contact::detail
