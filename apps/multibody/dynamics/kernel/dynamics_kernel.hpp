#pragma once

#include <memory>

#include "libcontact/base/instruction_set.hpp"
#include "multibody/dynamics/carrier_equations.hpp"
#include "multibody/system/active_forces.hpp"
#include "multibody/system/constants.hpp"
#include "multibody/system/state_layout.hpp"

namespace multibody::detail {

/// TwoStep<double, S> for the lanes S of one instruction set.
class DynamicsKernel {
 public:
  virtual ~DynamicsKernel() = default;
  virtual void set_mode(int body, JointMode mode) = 0;
  virtual void evaluate(const double* state,
                        const CarrierActiveForces<double>& carrier,
                        const LinkForces<double>* bodies) = 0;
  virtual void evaluate_prescribed(
      const double* state, const LinkForces<double>* bodies,
      const CarrierAcceleration<double>& carrier) = 0;
  virtual void add_friction(const Vec3<double>* change) = 0;
  virtual void add_friction(const VectorRows& change) = 0;
  virtual const CarrierAcceleration<double>& carrier() const = 0;
  virtual Vec3<double> relative_acceleration(int body) const = 0;
  virtual void relative_accelerations(Vec3<double>* to) const = 0;
  virtual Vec3<double> angular_acceleration(int body) const = 0;
  virtual Mat3<double> axes(int body) const = 0;
  virtual void rates(const double* state, const Vec3<double>& gravity,
                     double* to) const = 0;
  virtual void reactions(Reaction<double>* to) const = 0;
  virtual void reactions(const VectorRows& force,
                         const VectorRows* moment) const = 0;
};

/// @param constants  kept by reference
/// @param set        a supported one
std::unique_ptr<DynamicsKernel> make_dynamics_kernel(
    const SystemConstants& constants, contact::InstructionSet set);

}  // namespace multibody::detail
