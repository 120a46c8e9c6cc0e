#pragma once

/// Vectors and matrices of three dimensions for any scalar: a double, SIMD
/// lanes, a counting scalar. Mixed operands (constants in double, state in
/// lanes) are allowed. Every function is written out, so that the compiler sees
/// straight-line arithmetic and a counting scalar sees exactly the operations
/// that are needed; and always inlined, so that files compiled for different
/// instruction sets share none of them.
namespace contact {

template <class T>
struct Vec3 {
  T x, y, z;
};
// Clang below 17 has no deduction for aggregates (P1816) without a guide.
template <class T>
Vec3(T, T, T) -> Vec3<T>;

/// By columns.
template <class T>
struct Mat3 {
  Vec3<T> x, y, z;
};

template <class A, class B>
[[gnu::always_inline]] inline auto operator+(const Vec3<A>& a,
                                             const Vec3<B>& b) {
  return Vec3{a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class A, class B>
[[gnu::always_inline]] inline auto operator-(const Vec3<A>& a,
                                             const Vec3<B>& b) {
  return Vec3{a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class A, class B>
[[gnu::always_inline]] inline auto operator*(const A& s, const Vec3<B>& v) {
  return Vec3{s * v.x, s * v.y, s * v.z};
}
template <class A, class B>
[[gnu::always_inline]] inline void operator+=(Vec3<A>& a, const Vec3<B>& b) {
  a.x += b.x;
  a.y += b.y;
  a.z += b.z;
}
template <class A, class B>
[[gnu::always_inline]] inline void operator-=(Vec3<A>& a, const Vec3<B>& b) {
  a.x -= b.x;
  a.y -= b.y;
  a.z -= b.z;
}
template <class A, class B>
[[gnu::always_inline]] inline auto dot(const Vec3<A>& a, const Vec3<B>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class A, class B>
[[gnu::always_inline]] inline auto cross(const Vec3<A>& a, const Vec3<B>& b) {
  return Vec3{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
              a.x * b.y - a.y * b.x};
}
template <class A, class B>
[[gnu::always_inline]] inline auto operator*(const Mat3<A>& m,
                                             const Vec3<B>& v) {
  return Vec3{m.x.x * v.x + m.y.x * v.y + m.z.x * v.z,
              m.x.y * v.x + m.y.y * v.y + m.z.y * v.z,
              m.x.z * v.x + m.y.z * v.y + m.z.z * v.z};
}

}  // namespace contact
