#pragma once

#include "multibody/dynamics/carrier_equations.hpp"
#include "multibody/dynamics/state_rates.hpp"
#include "multibody/system/active_forces.hpp"
#include "multibody/system/constants.hpp"
#include "multibody/system/state_layout.hpp"

namespace multibody {

/// A body without a hinge: Euler's equations, link axes. It does not enter the
/// carrier's equations.
template <class T, class P>
class FreeLink {
 public:
  static constexpr int state_begin = StateLayout::angular_velocity;
  static constexpr int state_size = 3;
  static constexpr bool serves(HingeKind, JointMode mode) {
    return mode == JointMode::released;
  }
  static double constant(const SystemConstants& s, int body, std::size_t i) {
    return number_of(s.free(body), i);
  }
  template <class F>
  void set_constants(F number) {
    set_numbers(k_, number);
  }

  CarrierMatrix<P> fixed_part() const { return {}; }
  /// @param state  absolute angular velocity
  [[gnu::always_inline]] void set_motion(const T* state,
                                         const CarrierMotion<T>&,
                                         const LinkForces<T>& forces) {
    const Vec3<T> w{state[0], state[1], state[2]};
    linear_ = k_.inverse_mass * forces.force;
    angular_ = k_.inverse_inertia * (forces.moment - cross(w, k_.inertia * w));
  }
  void add_to(CarrierForces<T>&) const {}
  void add_to(CarrierMatrix<T>&) const {}
  void add_friction(const Vec3<T>&, CarrierForces<T>&) {}

  /// Derivatives of the numbers that begin at `at`.
  template <class N>
  [[gnu::always_inline]] static void put_rates(
      const N* state, int at, const Vec3<N>& gravity,
      const BodyAcceleration<N>& acceleration, N* to) {
    body_rates(state, at, acceleration.linear, gravity, acceleration.turn, to);
  }
  /// Acceleration of the centre of mass without gravity, link axes.
  const Vec3<T>& linear_acceleration() const { return linear_; }
  /// Absolute, because the body has no hinge.
  Vec3<T> relative_acceleration(const CarrierAcceleration<T>&) const {
    return angular_;
  }
  Vec3<T> angular_acceleration(const CarrierAcceleration<T>&) const {
    return angular_;
  }
  Reaction<T> reaction(const CarrierAcceleration<T>&) const { return {}; }
  Mat3<T> axes() const { return {}; }

 private:
  FreeConstants<P> k_;
  Vec3<T> linear_;
  Vec3<T> angular_;
};

}  // namespace multibody
