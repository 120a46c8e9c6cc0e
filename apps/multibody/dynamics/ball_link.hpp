#pragma once

#include "multibody/dynamics/carrier_equations.hpp"
#include "multibody/dynamics/held_link.hpp"
#include "multibody/dynamics/state_rates.hpp"
#include "multibody/system/active_forces.hpp"
#include "multibody/system/constants.hpp"
#include "multibody/system/hinges/ball.hpp"
#include "multibody/system/state_layout.hpp"

namespace multibody {

/// One body on a ball joint, (1.3), (1.4), in the axes in which N_i is
/// diagonal. With the moments about the centre of mass less the gyroscopic
/// ones, M = M_com + M_t - w x I w, and U of BallConstants,
///   e = diag(1/d_x, 1/d_y) (M_xy - u M_z),
///   a = v'_i - F/m - w~^2 r,
///   R = N a + m arm (-e_y, e_x, 0),
///   w'_x = e_x - k_x a_y,  w'_y = e_y + k_y a_x,
///   w'_z = M_z/I_zz - u . w'_xy.
template <class T, class P>
class BallLink {
 public:
  static constexpr int state_begin = 0;
  static constexpr int state_size = 7;
  static constexpr bool serves(HingeKind kind, JointMode mode) {
    return kind == HingeKind::ball && mode == JointMode::turning;
  }
  static double constant(const SystemConstants& s, int body, std::size_t i) {
    return s.turning(body)[i];
  }
  template <class F>
  void set_constants(F number) {
    set_numbers(k_, number);
  }

  /// n_y E of N_i acts like a mass at the hinge.
  CarrierMatrix<P> fixed_part() const { return point_mass(k_.n.y, k_.hinge); }

  /// Sets the quantities that follow from the motion alone.
  /// @param state  quaternion of C_i and relative angular velocity
  [[gnu::always_inline]] void set_motion(const T* state,
                                         const CarrierMotion<T>& carrier,
                                         const LinkForces<T>& forces) {
    c_ = rotation(Quaternion<T>{state[0], state[1], state[2], state[3]});
    const Vec3<T> relative{state[4], state[5], state[6]};
    const Vec3<T> w0 = transposed_times(c_, carrier.w);
    const Vec3<T> w = w0 + relative;
    gyroscopic_ = cross(relative, w0);
    friction_ = forces.friction;

    const T hz = k_.spin * (w.z + k_.ux * w.x + k_.uy * w.y);
    const Vec3<T> h{k_.ix * w.x + k_.ux * hz, k_.iy * w.y + k_.uy * hz, hz};
    const Vec3<T> m = forces.moment + friction_ - cross(w, h);
    e_x_ = k_.inverse_dx * (m.x - k_.ux * m.z);
    e_y_ = k_.inverse_dy * (m.y - k_.uy * m.z);
    spin_ = k_.inverse_spin * m.z;

    a_ = transposed_times(c_, carrier.squared * k_.hinge) -
         k_.inverse_mass * forces.force;
    const T arm_wz = k_.arm * w.z;
    a_.x -= arm_wz * w.x;
    a_.y -= arm_wz * w.y;
    a_.z += k_.arm * (w.x * w.x + w.y * w.y);
  }

  /// The body's part of the carrier's right-hand sides.
  void add_to(CarrierForces<T>& forces) const {
    forces.subtract(c_ * force(a_), k_.hinge, c_ * friction_);
  }

  /// The body's part of the carrier's matrix, less fixed_part():
  /// N' = C N C^T with diag(n_x - n_y, 0, n_z - n_y) in place of N.
  void add_to(CarrierMatrix<T>& matrix) const {
    const Vec3<T> x = k_.n_xy * c_.x;
    const Vec3<T> z = k_.n_zy * c_.z;
    const auto entry = [](const T& x1, const T& x2, const T& z1, const T& z2) {
      return T(x1 * x2 + z1 * z2);
    };
    const Sym3<T> n{
        entry(x.x, c_.x.x, z.x, c_.z.x), entry(x.y, c_.x.y, z.y, c_.z.y),
        entry(x.z, c_.x.z, z.z, c_.z.z), entry(x.x, c_.x.y, z.x, c_.z.y),
        entry(x.x, c_.x.z, z.x, c_.z.z), entry(x.y, c_.x.z, z.y, c_.z.z)};
    // Rows of N' r~_0 are minus the cross products of r_0 with rows of N'.
    const Vec3<P>& r = k_.hinge;
    const Vec3<T> sx = cross(r, Vec3<T>{n.xx, n.xy, n.xz});
    const Vec3<T> sy = cross(r, Vec3<T>{n.xy, n.yy, n.yz});
    const Vec3<T> sz = cross(r, Vec3<T>{n.xz, n.yz, n.zz});
    matrix.a += n;
    matrix.b_transposed.x += sx;
    matrix.b_transposed.y += sy;
    matrix.b_transposed.z += sz;
    matrix.f.xx += r.y * sz.x - r.z * sy.x;
    matrix.f.yy += r.z * sx.y - r.x * sz.y;
    matrix.f.zz += r.x * sy.z - r.y * sx.z;
    matrix.f.xy += r.y * sz.y - r.z * sy.y;
    matrix.f.xz += r.y * sz.z - r.z * sy.z;
    matrix.f.yz += r.z * sx.z - r.x * sz.z;
  }

  /// Changes the friction moment: computes only its effect.
  void add_friction(const Vec3<T>& change, CarrierForces<T>& forces) {
    const T dx = k_.inverse_dx * (change.x - k_.ux * change.z);
    const T dy = k_.inverse_dy * (change.y - k_.uy * change.z);
    e_x_ += dx;
    e_y_ += dy;
    spin_ += k_.inverse_spin * change.z;
    friction_ += change;
    const T rx = -k_.mass_arm * dy;
    const T ry = k_.mass_arm * dx;
    forces.subtract(rx * c_.x + ry * c_.y, k_.hinge, c_ * change);
  }

  /// Relative angular acceleration, link axes.
  Vec3<T> relative_acceleration(const CarrierAcceleration<T>& carrier) const {
    const Vec3<T> a = hinge_acceleration(carrier);
    return angular(a) - transposed_times(c_, carrier.angular) + gyroscopic_;
  }
  /// Absolute angular acceleration, link axes.
  Vec3<T> angular_acceleration(const CarrierAcceleration<T>& carrier) const {
    return angular(hinge_acceleration(carrier));
  }
  Reaction<T> reaction(const CarrierAcceleration<T>& carrier) const {
    return {force(hinge_acceleration(carrier)), {T(0.0), T(0.0), T(0.0)}};
  }
  /// Derivatives of the numbers that begin at `at`.
  template <class N>
  [[gnu::always_inline]] static void put_rates(
      const N* state, int at, const Vec3<N>&,
      const BodyAcceleration<N>& acceleration, N* to) {
    turn_rates(state, at, at + 4, acceleration.turn, to);
  }
  /// Link axes to carrier axes.
  const Mat3<T>& axes() const { return c_; }

 private:
  // a with the carrier's accelerations.
  Vec3<T> hinge_acceleration(const CarrierAcceleration<T>& carrier) const {
    return a_ + transposed_times(
                    c_, carrier.linear + cross(carrier.angular, k_.hinge));
  }
  Vec3<T> force(const Vec3<T>& a) const {
    return {k_.n.x * a.x - k_.mass_arm * e_y_,
            k_.n.y * a.y + k_.mass_arm * e_x_, k_.n.z * a.z};
  }
  Vec3<T> angular(const Vec3<T>& a) const {
    const T x = e_x_ - k_.kx * a.y;
    const T y = e_y_ + k_.ky * a.x;
    return {x, y, spin_ - k_.ux * x - k_.uy * y};
  }

  BallConstants<P> k_;
  Mat3<T> c_;
  Vec3<T> gyroscopic_;
  Vec3<T> friction_;
  Vec3<T> a_;  ///< a for V' = w' = 0
  T e_x_, e_y_;
  T spin_;  ///< M_z/I_zz
};

/// Held in a ball joint.
template <class T, class P>
class HeldBall : public HeldLink<T, P> {
 public:
  static constexpr int state_begin = 0;
  static constexpr int state_size = 4;
  static constexpr bool serves(HingeKind kind, JointMode mode) {
    return kind == HingeKind::ball && mode == JointMode::held;
  }
  /// Its numbers do not change.
  template <class N>
  [[gnu::always_inline]] static void put_rates(const N*, int at, const Vec3<N>&,
                                               const BodyAcceleration<N>&,
                                               N* to) {
    put_zeros<HingeKind::ball>(at, to);
  }
  /// @param state  quaternion of C_i
  [[gnu::always_inline]] void set_motion(const T* state,
                                         const CarrierMotion<T>& carrier,
                                         const LinkForces<T>& forces) {
    HeldLink<T, P>::set_motion(
        rotation(Quaternion<T>{state[0], state[1], state[2], state[3]}),
        carrier, forces);
  }
};

}  // namespace multibody
