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
  void set_mode(int body, JointMode mode) override {
    two_step_.set_mode(body, mode);
  }
  void evaluate(const double* state, const CarrierActiveForces<double>& carrier,
                const LinkForces<double>* bodies) override {
    two_step_.evaluate(state, carrier, numbers(bodies));
  }
  void evaluate_prescribed(
      const double* state, const LinkForces<double>* bodies,
      const CarrierAcceleration<double>& carrier) override {
    two_step_.evaluate_prescribed(state, numbers(bodies), carrier);
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
  Vec3<double> relative_acceleration(int body) const override {
    return two_step_.relative_acceleration(body);
  }
  void relative_accelerations(Vec3<double>* to) const override {
    two_step_.relative_accelerations(
        [to](int body, const Vec3<double>& a) { to[body] = a; });
  }
  Vec3<double> angular_acceleration(int body) const override {
    return two_step_.angular_acceleration(body);
  }
  Mat3<double> axes(int body) const override { return two_step_.axes(body); }
  void rates(const double* state, const Vec3<double>& gravity,
             double* to) const override {
    two_step_.rates(state, gravity, to);
  }
  void reactions(Reaction<double>* to) const override {
    two_step_.reactions(to);
  }
  void reactions(const VectorRows& force,
                 const VectorRows* moment) const override {
    two_step_.reactions(force, moment);
  }

 private:
  static const double* numbers(const LinkForces<double>* bodies) {
    static_assert(sizeof(LinkForces<double>) == 9 * sizeof(double));
    return reinterpret_cast<const double*>(bodies);
  }

  TwoStep<double, S> two_step_;
};

}  // namespace multibody::detail
