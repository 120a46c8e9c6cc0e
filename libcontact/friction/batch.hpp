#pragma once

#include <span>

#include "libcontact/base/instruction_set.hpp"

namespace contact {

/// Arguments of many points, structure of arrays of equal length; meaning,
/// units and intervals as in exact_friction_integrals().
struct FrictionBatchInput {
  std::span<const double> half_angle;
  std::span<const double> axis_sin;
  std::span<const double> axis_cos;
};

/// Results, each as long as the input or empty where it is not wanted;
/// meaning as in FrictionIntegrals.
struct FrictionBatchOutput {
  std::span<double> normal;
  std::span<double> force_pressure, sliding_pressure, spinning_pressure;
  std::span<double> force_area, sliding_area, spinning_area;
  std::span<double> force, sliding, spinning;
};

/// exact_friction_integrals() for many points, vectorised over points: the
/// same numbers as the scalar call's to rounding, largest relative error
/// 1.7e-15 on data/reference (friction/batch_test.cpp). NaN and out-of-range
/// arguments give NaN in their own places. Works in blocks with its scratch
/// memory on the stack; allocates nothing.
///
/// @param in   arguments
/// @param out  results; must not overlap the arguments
/// @param set  instruction set, by default the widest of the machine
/// @throws Error if lengths differ or the machine lacks `set`.
void exact_friction_integrals(const FrictionBatchInput& in,
                              const FrictionBatchOutput& out,
                              InstructionSet set = best_instruction_set());

}  // namespace contact
