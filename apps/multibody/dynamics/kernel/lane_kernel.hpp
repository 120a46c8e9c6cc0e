#pragma once

#include <memory>

#include "libcontact/base/instruction_set.hpp"
#include "multibody/system/constants.hpp"
#include "multibody/system/state_layout.hpp"

namespace multibody::detail {

/// TwoStep<V, P> with lanes V over motions; see LaneDynamics, whose arrays it
/// takes.
class LaneKernel {
 public:
  virtual ~LaneKernel() = default;
  virtual void set_mode(int load, JointMode mode) = 0;
  virtual void evaluate(const double* state, const double* loading) = 0;
  virtual void add_friction(const double* change) = 0;
  virtual void accelerations(double* to) const = 0;
  virtual void rates(const double* state, const double* gravity,
                     double* to) const = 0;
  virtual void reactions(double* to) = 0;
};

/// Motions of one system, or of systems that differ in numbers.
/// @param constants  one, or as many as lanes; kept by reference
std::unique_ptr<LaneKernel> make_lane_kernel(
    const SystemConstants* const* constants, bool same_system,
    contact::InstructionSet set);

/// Lanes of an instruction set.
int lane_width(contact::InstructionSet set);

}  // namespace multibody::detail
