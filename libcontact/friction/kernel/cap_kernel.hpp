#pragma once

#include "libcontact/base/instruction_set.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/friction/kernel/arc_sum.hpp"
#include "libcontact/friction/kernel/cap_integrals.hpp"
#include "libcontact/friction/kernel/expansion_table.hpp"
#include "libcontact/pressure/expansion.hpp"

namespace contact::detail {

/// The exact method's loops over nodes, compiled once per instruction set.
struct CapKernel {
  /// One point, lanes over nodes.
  CapSums<double> (*one)(const CapPoint<double>&, const CapRule&,
                         bool pole_inside, ArcRange);
  static constexpr int few_points = 8;
  /// Up to so many points, lanes over points; few of a branch or such that want
  /// many nodes one after the other, lanes over nodes. Rows of 8 numbers:
  /// coefficients of force, sliding and spinning, then the area integrals.
  /// Wanted are those whose number in that row is not 0, among the first
  /// `count`; the others have to be numbers that can be read.
  /// The half-angle by its sine and cosine.
  void (*few)(const double* half_angle_sin, const double* half_angle_cos,
              const double* axis_sin, const double* axis_cos,
              const double* wanted, int count, double* integrals);
  /// Many points, lanes over points; sizes already checked. With a table of
  /// its pressure, or without for the cosine pressure.
  void (*batch)(const FrictionBatchInput&, const FrictionBatchOutput&,
                const ExpansionTable*);
  /// The integrals of a pressure but for its share of the cosine pressure,
  /// lanes along the arcs.
  PressureSums<double> (*root_pressure)(const ArcPoint<double>&,
                                        bool pole_inside,
                                        const PressureExpansion&);
};

/// The kernel for a supported instruction set.
const CapKernel& cap_kernel(InstructionSet set);

}  // namespace contact::detail
