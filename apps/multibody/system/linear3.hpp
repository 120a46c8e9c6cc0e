#pragma once

#include "libcontact/base/lanes/vec3.hpp"

/// With contact::Vec3: symmetric and rotation matrices of three dimensions for
/// any scalar, by the same rules.
namespace multibody {

using contact::Vec3;
/// Rotation by the unit vectors of the body's axes in the outer axes: C * v
/// turns body components into outer ones (the paper's C, B, B_0).
using contact::Mat3;

/// Symmetric matrix.
template <class T>
struct Sym3 {
  T xx, yy, zz, xy, xz, yz;
};
template <class T>
Sym3(T, T, T, T, T, T) -> Sym3<T>;

/// Quaternion of a rotation, scalar part first; any length but zero.
template <class T>
struct Quaternion {
  T w, x, y, z;
};

/// Component by component: the product with a diagonal matrix.
template <class A, class B>
[[gnu::always_inline]] inline auto scaled(const Vec3<A>& d, const Vec3<B>& v) {
  return Vec3{d.x * v.x, d.y * v.y, d.z * v.z};
}

/// m^T v: outer components into body ones.
template <class A, class B>
[[gnu::always_inline]] inline auto transposed_times(const Mat3<A>& m,
                                                    const Vec3<B>& v) {
  return Vec3{dot(m.x, v), dot(m.y, v), dot(m.z, v)};
}

template <class A, class B>
[[gnu::always_inline]] inline auto operator*(const Sym3<A>& m,
                                             const Vec3<B>& v) {
  return Vec3{m.xx * v.x + m.xy * v.y + m.xz * v.z,
              m.xy * v.x + m.yy * v.y + m.yz * v.z,
              m.xz * v.x + m.yz * v.y + m.zz * v.z};
}
template <class A, class B>
[[gnu::always_inline]] inline void operator+=(Sym3<A>& m, const Sym3<B>& n) {
  m.xx += n.xx;
  m.yy += n.yy;
  m.zz += n.zz;
  m.xy += n.xy;
  m.xz += n.xz;
  m.yz += n.yz;
}
/// m += a b^T for vectors that make it symmetric.
template <class T>
[[gnu::always_inline]] inline void add_outer(Sym3<T>& m, const Vec3<T>& a,
                                             const Vec3<T>& b) {
  m.xx += a.x * b.x;
  m.yy += a.y * b.y;
  m.zz += a.z * b.z;
  m.xy += a.x * b.y;
  m.xz += a.x * b.z;
  m.yz += a.y * b.z;
}

/// The square of the cross-product matrix: squared_cross(w) * r = w x (w x r).
template <class T>
[[gnu::always_inline]] inline Sym3<T> squared_cross(const Vec3<T>& w) {
  const T xx = w.x * w.x;
  const T yy = w.y * w.y;
  const T zz = w.z * w.z;
  return {-(yy + zz), -(xx + zz), -(xx + yy), w.x * w.y, w.x * w.z, w.y * w.z};
}

/// Rotation matrix of q; orthogonal to rounding whatever the length of q.
template <class T>
[[gnu::always_inline]] inline Mat3<T> rotation(const Quaternion<T>& q) {
  const T s = 2.0 / (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  const T sx = s * q.x;
  const T sy = s * q.y;
  const T sz = s * q.z;
  const T wx = q.w * sx;
  const T wy = q.w * sy;
  const T wz = q.w * sz;
  const T xx = q.x * sx;
  const T xy = q.x * sy;
  const T xz = q.x * sz;
  const T yy = q.y * sy;
  const T yz = q.y * sz;
  const T zz = q.z * sz;
  return {{1.0 - (yy + zz), xy + wz, xz - wy},
          {xy - wz, 1.0 - (xx + zz), yz + wx},
          {xz + wy, yz - wx, 1.0 - (xx + yy)}};
}

/// Axes m turned about their z by an angle given by cosine and sine.
template <class A, class T>
[[gnu::always_inline]] inline Mat3<T> turned_about_z(const Mat3<A>& m,
                                                     const T& cos,
                                                     const T& sin) {
  return {cos * m.x + sin * m.y,
          cos * m.y - sin * m.x,
          {T(m.z.x), T(m.z.y), T(m.z.z)}};
}

/// dq/dt = q o (0, w)/2 for an angular velocity w in body axes.
template <class T>
[[gnu::always_inline]] inline Quaternion<T> quaternion_rate(
    const Quaternion<T>& q, const Vec3<T>& w) {
  const Vec3<T> h = 0.5 * w;
  return {-(q.x * h.x + q.y * h.y + q.z * h.z),
          q.w * h.x + q.y * h.z - q.z * h.y, q.w * h.y + q.z * h.x - q.x * h.z,
          q.w * h.z + q.x * h.y - q.y * h.x};
}

/// Factors L D L^T of a symmetric positive definite matrix.
template <class T>
struct Factor3 {
  T yx, zx, zy;  ///< below the diagonal of L
  Vec3<T> inverse_d;

  Factor3() = default;
  [[gnu::always_inline]] explicit Factor3(const Sym3<T>& m) {
    inverse_d.x = 1.0 / m.xx;
    yx = m.xy * inverse_d.x;
    zx = m.xz * inverse_d.x;
    inverse_d.y = 1.0 / (m.yy - yx * m.xy);
    const T zy_d = m.yz - zx * m.xy;
    zy = zy_d * inverse_d.y;
    inverse_d.z = 1.0 / (m.zz - zx * m.xz - zy * zy_d);
  }
  /// L^-1 v
  [[gnu::always_inline]] Vec3<T> forward(const Vec3<T>& v) const {
    const T y = v.y - yx * v.x;
    return {v.x, y, v.z - zx * v.x - zy * y};
  }
  /// L^-T v
  [[gnu::always_inline]] Vec3<T> backward(const Vec3<T>& v) const {
    const T y = v.y - zy * v.z;
    return {v.x - yx * y - zx * v.z, y, v.z};
  }
};

}  // namespace multibody
