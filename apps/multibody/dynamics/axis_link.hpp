#pragma once

#include "libcontact/base/lanes/sine_cosine.hpp"
#include "multibody/dynamics/carrier_equations.hpp"
#include "multibody/dynamics/held_link.hpp"
#include "multibody/dynamics/state_rates.hpp"
#include "multibody/system/active_forces.hpp"
#include "multibody/system/constants.hpp"
#include "multibody/system/hinges/axis.hpp"
#include "multibody/system/state_layout.hpp"

namespace multibody {

/// One body on an axis, (1.6)-(1.8), eliminating only the rotation about the
/// axis: the body counts as one piece with the carrier, minus p p^T/J_zz for
/// its free rotation. J_i is never inverted, so its inertia may vanish. With w
/// the angular velocity and t' the rate of the angle,
///   G = F - m a,           a: acceleration of the centre of mass,
///   K = M_com - I (w' bias) - w x I w,
///   tau = M_t,z + K_z - arm G_y   (both for V' = w' = t'' = 0),
///   J_zz t'' = tau - p_linear . V' - p . w'.
template <class T, class P>
class AxisLink {
 public:
  static constexpr int state_begin = 0;
  static constexpr int state_size = 2;
  static constexpr bool serves(HingeKind kind, JointMode mode) {
    return kind == HingeKind::axis && mode == JointMode::turning;
  }
  static double constant(const SystemConstants& s, int body, std::size_t i) {
    return s.turning(body)[i];
  }
  template <class F>
  void set_constants(F number) {
    set_numbers(k_, number);
  }

  CarrierMatrix<P> fixed_part() const {
    CarrierMatrix<P> m = point_mass(k_.mass, k_.hinge);
    m.f = k_.f_1;
    return m;
  }

  /// Sets the quantities that follow from the motion alone.
  /// @param state  angle and its rate
  [[gnu::always_inline]] void set_motion(const T* state,
                                         const CarrierMotion<T>& carrier,
                                         const LinkForces<T>& forces) {
    const auto [sine, cosine] = contact::detail::sine_cosine_of_any(state[0]);
    cos_ = cosine;
    sin_ = sine;
    const T& rate = state[1];
    c_ = turned_about_z(k_.zero, cos_, sin_);
    p_ = k_.p_1 + cos_ * k_.p_cos + sin_ * k_.p_sin;

    const Vec3<T> w0 = transposed_times(c_, carrier.w);
    const Vec3<T> w{w0.x, w0.y, w0.z + rate};
    // w' for V' = w'_0 = t'' = 0
    turned_ = {rate * w0.y, -(rate * w0.x), T(0.0)};
    Vec3<T> a = transposed_times(c_, carrier.squared * k_.hinge);
    a.x += k_.arm * (w.y * w.y + w.z * w.z);
    a.y -= k_.arm * (w.x * w.y);
    a.z -= k_.arm * (w.x * (w.z + rate));
    g_ = forces.force - k_.mass * a;

    const Sym3<P>& i = k_.inertia;
    const Vec3<T> bias{i.xx * turned_.x + i.xy * turned_.y,
                       i.xy * turned_.x + i.yy * turned_.y,
                       i.xz * turned_.x + i.yz * turned_.y};
    moment_ = forces.moment - bias - cross(w, i * w);
    friction_ = forces.friction;
    tau_ = friction_.z + moment_.z - k_.arm * g_.y;
  }

  /// The body's part of the carrier's right-hand sides: force and moment about
  /// the foot that the rotation of the body does not balance.
  void add_to(CarrierForces<T>& forces) const {
    const Sym3<P>& i = k_.inertia;
    const T t = k_.inverse_jzz * tau_;
    const Vec3<T> force{-g_.x, -g_.y - k_.mass_arm * t, -g_.z};
    const Vec3<T> moment{i.xz * t - moment_.x,
                         i.yz * t - moment_.y - k_.arm * g_.z, friction_.z};
    forces.subtract(c_ * force, k_.hinge, c_ * moment);
  }

  /// The body's part of the carrier's matrix, less fixed_part().
  void add_to(CarrierMatrix<T>& matrix) const {
    const T cos2 = 1.0 - 2.0 * (sin_ * sin_);
    const T sin2 = 2.0 * (sin_ * cos_);
    const Vec3<T> y = k_.k * c_.y;
    const Vec3<T> minus_my = -k_.mass_arm * y;
    add_outer(matrix.a, minus_my, c_.y);
    matrix.b_transposed.x += y.x * p_;
    matrix.b_transposed.y += y.y * p_;
    matrix.b_transposed.z += y.z * p_;
    matrix.add_first_moment(-k_.mass_arm * c_.x);
    const auto entry = [&](auto m) {
      return cos_ * k_.f_cos.*m + sin_ * k_.f_sin.*m + cos2 * k_.f_cos2.*m +
             sin2 * k_.f_sin2.*m;
    };
    matrix.f.xx += entry(&Sym3<P>::xx);
    matrix.f.yy += entry(&Sym3<P>::yy);
    matrix.f.zz += entry(&Sym3<P>::zz);
    matrix.f.xy += entry(&Sym3<P>::xy);
    matrix.f.xz += entry(&Sym3<P>::xz);
    matrix.f.yz += entry(&Sym3<P>::yz);
  }

  /// Changes the friction moment: computes only its effect.
  void add_friction(const Vec3<T>& change, CarrierForces<T>& forces) {
    friction_ += change;
    tau_ += change.z;
    const T t = k_.inverse_jzz * change.z;
    forces.a += (k_.mass_arm * t) * c_.y;
    forces.b -= t * p_;
  }

  /// Relative angular acceleration, link axes: (0, 0, t'').
  Vec3<T> relative_acceleration(const CarrierAcceleration<T>& carrier) const {
    return {T(0.0), T(0.0),
            k_.inverse_jzz * (tau_ + k_.mass_arm * dot(c_.y, carrier.linear) -
                              dot(p_, carrier.angular))};
  }
  /// Absolute angular acceleration, link axes.
  Vec3<T> angular_acceleration(const CarrierAcceleration<T>& carrier) const {
    return transposed_times(c_, carrier.angular) + turned_ +
           relative_acceleration(carrier);
  }
  Reaction<T> reaction(const CarrierAcceleration<T>& carrier) const {
    // Angular acceleration less the part that K and a hold already.
    const Vec3<T> w =
        transposed_times(c_, carrier.angular) + relative_acceleration(carrier);
    Vec3<T> a =
        transposed_times(c_, carrier.linear + cross(carrier.angular, k_.hinge));
    a.y -= k_.arm * w.z;
    a.z += k_.arm * w.y;
    const Vec3<T> r = k_.mass * a - g_;
    // About the foot, then about the hinge's centre.
    const Vec3<T> m = k_.inertia * w - moment_ - friction_;
    return {r,
            {m.x + k_.pole_offset * r.y,
             m.y + k_.arm * r.z - k_.pole_offset * r.x, T(0.0)}};
  }
  /// Derivatives of the numbers that begin at `at`.
  template <class N>
  [[gnu::always_inline]] static void put_rates(
      const N* state, int at, const Vec3<N>&,
      const BodyAcceleration<N>& acceleration, N* to) {
    to[at] = state[at + 1];
    to[at + 1] = acceleration.turn.z;
  }
  /// Link axes to carrier axes.
  const Mat3<T>& axes() const { return c_; }

 private:
  AxisConstants<P> k_;
  T cos_, sin_;
  Mat3<T> c_;
  Vec3<T> p_;
  Vec3<T> turned_;
  Vec3<T> g_;
  Vec3<T> moment_;  ///< K
  Vec3<T> friction_;
  T tau_;
};

/// Held on an axis.
template <class T, class P>
class HeldAxis : public HeldLink<T, P> {
 public:
  static constexpr int state_begin = 0;
  static constexpr int state_size = 1;
  static constexpr bool serves(HingeKind kind, JointMode mode) {
    return kind == HingeKind::axis && mode == JointMode::held;
  }
  /// Its numbers do not change.
  template <class N>
  [[gnu::always_inline]] static void put_rates(const N*, int at, const Vec3<N>&,
                                               const BodyAcceleration<N>&,
                                               N* to) {
    put_zeros<HingeKind::axis>(at, to);
  }
  /// @param state  angle
  [[gnu::always_inline]] void set_motion(const T* state,
                                         const CarrierMotion<T>& carrier,
                                         const LinkForces<T>& forces) {
    const auto [sine, cosine] = contact::detail::sine_cosine_of_any(state[0]);
    HeldLink<T, P>::set_motion(turned_about_z(this->k_.zero, cosine, sine),
                               carrier, forces);
  }
};

}  // namespace multibody
