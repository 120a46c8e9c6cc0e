#pragma once

// Included by each dynamics_kernel_*.cpp, which is compiled for its own
// instruction set and has lanes S of its own.

#include "multibody/dynamics/kernel/dynamics_kernel.hpp"
#include "multibody/dynamics/two_step.hpp"

namespace multibody::detail {

template <class S>
class DynamicsKernelOf final : public DynamicsKernel {
 public:
  explicit DynamicsKernelOf(const SystemConstants& constants)
      : two_step_(constants) {}
  void set_mode(int load, JointMode mode) override {
    two_step_.set_mode(load, mode);
  }
  void evaluate(const double* state, const CarrierLoading<double>& carrier,
                const LoadForces<double>* loads) override {
    two_step_.evaluate(state, carrier, numbers(loads));
  }
  void evaluate_prescribed(
      const double* state, const LoadForces<double>* loads,
      const CarrierAcceleration<double>& carrier) override {
    two_step_.evaluate_prescribed(state, numbers(loads), carrier);
  }
  void add_friction(const Vec3<double>* change) override {
    two_step_.add_friction(&change->x);
  }
  void add_friction(const VectorRows& change) override {
    two_step_.add_friction(change);
  }
  const CarrierAcceleration<double>& carrier() const override {
    return two_step_.carrier();
  }
  Vec3<double> relative_acceleration(int load) const override {
    return two_step_.relative_acceleration(load);
  }
  void relative_accelerations(Vec3<double>* to) const override {
    two_step_.relative_accelerations(
        [to](int load, const Vec3<double>& a) { to[load] = a; });
  }
  Vec3<double> angular_acceleration(int load) const override {
    return two_step_.angular_acceleration(load);
  }
  Mat3<double> axes(int load) const override { return two_step_.axes(load); }
  void rates(const double* state, const Vec3<double>& gravity,
             double* to) const override {
    two_step_.rates(state, gravity, to);
  }
  void reactions(Reaction<double>* to) const override {
    two_step_.reactions(to);
  }
  void forces(const VectorRows& to) const override { two_step_.forces(to); }

 private:
  static const double* numbers(const LoadForces<double>* loads) {
    static_assert(sizeof(LoadForces<double>) == 9 * sizeof(double));
    return reinterpret_cast<const double*>(loads);
  }

  TwoStep<double, S> two_step_;
};

}  // namespace multibody::detail
