#pragma once

#include <memory>

#include "libcontact/base/instruction_set.hpp"
#include "multibody/dynamics/carrier_equations.hpp"
#include "multibody/system/constants.hpp"
#include "multibody/system/loading.hpp"
#include "multibody/system/state_layout.hpp"

namespace multibody::detail {

/// TwoStep<double, S> for the lanes S of one instruction set.
class DynamicsKernel {
 public:
  virtual ~DynamicsKernel() = default;
  virtual void set_mode(int load, JointMode mode) = 0;
  virtual void evaluate(const double* state,
                        const CarrierLoading<double>& carrier,
                        const LoadForces<double>* loads) = 0;
  virtual void evaluate_prescribed(
      const double* state, const LoadForces<double>* loads,
      const CarrierAcceleration<double>& carrier) = 0;
  virtual void add_friction(const Vec3<double>* change) = 0;
  virtual void add_friction(const VectorRows& change) = 0;
  virtual const CarrierAcceleration<double>& carrier() const = 0;
  virtual Vec3<double> relative_acceleration(int load) const = 0;
  virtual void relative_accelerations(Vec3<double>* to) const = 0;
  virtual Vec3<double> angular_acceleration(int load) const = 0;
  virtual Mat3<double> axes(int load) const = 0;
  virtual void rates(const double* state, const Vec3<double>& gravity,
                     double* to) const = 0;
  virtual void reactions(Reaction<double>* to) const = 0;
  virtual void forces(const VectorRows& to) const = 0;
};

/// @param constants  kept by reference
/// @param set        a supported one
std::unique_ptr<DynamicsKernel> make_dynamics_kernel(
    const SystemConstants& constants, contact::InstructionSet set);

}  // namespace multibody::detail
