#pragma once

#include "multibody/system/linear3.hpp"

/// The carrier's side of the two-step resolution, (1.4), (1.5).
namespace multibody {

/// Accelerations of the carrier, carrier axes.
template <class T>
struct CarrierAcceleration {
  Vec3<T> linear;   ///< centre of mass without gravity (V'_0), m/s^2
  Vec3<T> angular;  ///< w'_0, rad/s^2
};

/// Motion of the carrier as the bodies need it, carrier axes.
template <class T>
struct CarrierMotion {
  Vec3<T> w;        ///< angular velocity
  Sym3<T> squared;  ///< cross-product matrix of w, squared
};

/// The symmetric matrix of (1.4): A V' + B w' = a, B^T V' + F w' = b.
template <class T>
struct CarrierMatrix {
  Sym3<T> a;
  Mat3<T> b_transposed;  ///< columns: the rows of B
  Sym3<T> f;

  template <class P>
  [[gnu::always_inline]] void operator+=(const CarrierMatrix<P>& m) {
    a += m.a;
    b_transposed.x += m.b_transposed.x;
    b_transposed.y += m.b_transposed.y;
    b_transposed.z += m.b_transposed.z;
    f += m.f;
  }
  /// A mass at a point, given as mass times point: B += -c~.
  template <class P>
  [[gnu::always_inline]] void add_first_moment(const Vec3<P>& c) {
    b_transposed.x.y += c.z;
    b_transposed.x.z -= c.y;
    b_transposed.y.x -= c.z;
    b_transposed.y.z += c.x;
    b_transposed.z.x += c.y;
    b_transposed.z.y -= c.x;
  }
};

/// Contribution of a point mass fixed to the carrier to the matrix.
template <class P>
[[gnu::always_inline]] inline CarrierMatrix<P> point_mass(const P& mass,
                                                          const Vec3<P>& at) {
  CarrierMatrix<P> m{};
  m.a.xx = m.a.yy = m.a.zz = mass;
  m.add_first_moment(mass * at);
  const Sym3<P> s = squared_cross(at);
  m.f = {-mass * s.xx, -mass * s.yy, -mass * s.zz,
         -mass * s.xy, -mass * s.xz, -mass * s.yz};
  return m;
}

/// Right-hand sides of (1.4).
template <class T>
struct CarrierForces {
  Vec3<T> a;
  Vec3<T> b;

  /// The opposite of a body's reaction: a force at a point and a moment.
  template <class P>
  [[gnu::always_inline]] void subtract(const Vec3<T>& force, const Vec3<P>& at,
                                       const Vec3<T>& moment) {
    a -= force;
    b -= moment + cross(at, force);
  }
};

/// Solution (1.5) by blocks: F = L D L^T, then A - B F^-1 B^T the same way.
/// The factors stay valid while only right-hand sides change. Without
/// pivoting and without square roots; as accurate as the condition of the
/// matrix allows, which explicit 3x3 inverses are not.
template <class T>
class CarrierSolver {
 public:
  CarrierSolver() = default;
  [[gnu::always_inline]] explicit CarrierSolver(const CarrierMatrix<T>& m)
      : f_(m.f) {
    const Mat3<T>& b = m.b_transposed;
    w_ = {f_.forward(b.x), f_.forward(b.y), f_.forward(b.z)};
    mass_ = Factor3<T>(reduced(m.a, w_, f_.inverse_d));
  }

  [[gnu::always_inline]] CarrierAcceleration<T> solve(
      const CarrierForces<T>& forces) const {
    const Vec3<T> y = scaled(f_.inverse_d, f_.forward(forces.b));
    const Vec3<T> v = mass_.backward(scaled(
        mass_.inverse_d, mass_.forward(forces.a - transposed_times(w_, y))));
    return {v, f_.backward(y - scaled(f_.inverse_d, w_ * v))};
  }

 private:
  // M_0 = A - W^T D^-1 W with W = L^-1 B^T.
  [[gnu::always_inline]] static Sym3<T> reduced(Sym3<T> a, const Mat3<T>& w,
                                                const Vec3<T>& d) {
    const Vec3<T> x = scaled(d, w.x);
    const Vec3<T> y = scaled(d, w.y);
    const Vec3<T> z = scaled(d, w.z);
    a.xx -= dot(x, w.x);
    a.yy -= dot(y, w.y);
    a.zz -= dot(z, w.z);
    a.xy -= dot(x, w.y);
    a.xz -= dot(x, w.z);
    a.yz -= dot(y, w.z);
    return a;
  }

  Factor3<T> f_;
  Mat3<T> w_;
  Factor3<T> mass_;
};

}  // namespace multibody
