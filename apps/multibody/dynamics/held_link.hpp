#pragma once

#include "multibody/dynamics/carrier_equations.hpp"
#include "multibody/system/active_forces.hpp"
#include "multibody/system/constants.hpp"
#include "multibody/system/state_layout.hpp"

namespace multibody {

/// One body that does not turn in its joint: the formulas of the axis with D =
/// E, in which the body counts as one piece with the carrier and M is the held
/// moment. Friction moments have no effect.
template <class T, class P>
class HeldLink {
 public:
  static double constant(const SystemConstants& s, int body, std::size_t i) {
    return number_of(s.held(body), i);
  }
  template <class F>
  void set_constants(F number) {
    set_numbers(k_, number);
  }

  CarrierMatrix<P> fixed_part() const {
    return {};  // everything depends on where the body was stopped
  }

  void add_to(CarrierForces<T>& forces) const {
    forces.subtract(T(-1.0) * (c_ * g_), k_.hinge,
                    c_ * (cross(k_.r, g_) - moment_));
  }

  void add_to(CarrierMatrix<T>& matrix) const {
    const Vec3<T> com = k_.hinge - c_ * k_.r;
    const Sym3<P>& i = k_.inertia;
    matrix += point_mass(T(k_.mass), com);
    // C I C^T
    const Vec3<T> x = i.xx * c_.x + i.xy * c_.y + i.xz * c_.z;
    const Vec3<T> y = i.xy * c_.x + i.yy * c_.y + i.yz * c_.z;
    const Vec3<T> z = i.xz * c_.x + i.yz * c_.y + i.zz * c_.z;
    add_outer(matrix.f, x, c_.x);
    add_outer(matrix.f, y, c_.y);
    add_outer(matrix.f, z, c_.z);
  }

  void add_friction(const Vec3<T>&, CarrierForces<T>&) {}

  Vec3<T> relative_acceleration(const CarrierAcceleration<T>&) const {
    return {T(0.0), T(0.0), T(0.0)};
  }
  Vec3<T> angular_acceleration(const CarrierAcceleration<T>& carrier) const {
    return transposed_times(c_, carrier.angular);
  }
  Reaction<T> reaction(const CarrierAcceleration<T>& carrier) const {
    const Vec3<T> w = angular_acceleration(carrier);
    const Vec3<T> a =
        transposed_times(c_,
                         carrier.linear + cross(carrier.angular, k_.hinge)) -
        cross(w, k_.r);
    const Vec3<T> r = k_.mass * a - g_;
    Vec3<T> m = k_.inertia * w - moment_ - cross(k_.r, r);
    m.x += k_.pole_offset * r.y;
    m.y -= k_.pole_offset * r.x;
    return {r, m};
  }
  /// Link axes to carrier axes.
  const Mat3<T>& axes() const { return c_; }

 protected:
  [[gnu::always_inline]] void set_motion(const Mat3<T>& axes,
                                         const CarrierMotion<T>& carrier,
                                         const LinkForces<T>& forces) {
    c_ = axes;
    const Vec3<T> w = transposed_times(c_, carrier.w);
    const Vec3<T> a = transposed_times(c_, carrier.squared * k_.hinge) -
                      cross(w, cross(w, k_.r));
    g_ = forces.force - k_.mass * a;
    moment_ = forces.moment - cross(w, k_.inertia * w);
  }

  HeldConstants<P> k_;

 private:
  Mat3<T> c_;
  Vec3<T> g_;       ///< F - m a for V' = w' = 0
  Vec3<T> moment_;  ///< M_com - w x I w
};

}  // namespace multibody
