#pragma once

#include "libcontact/base/simd.hpp"
#include "multibody/dynamics/forest_part.hpp"

/// Vectors of three dimensions for the kernels of a forest: Vec3<double>, or
/// four lanes whose last is 0. Matrices are three columns V.
namespace multibody::detail {

template <int n, contact::detail::LaneSet set>
using LanesOf = contact::detail::LanesOf<n, set>;

/// One component, to be multiplied by a vector.
template <int i, contact::detail::LaneSet set>
[[gnu::always_inline]] inline LanesOf<4, set> part(const LanesOf<4, set>& v) {
  return LanesOf<4, set>(
      __builtin_shufflevector(v.native(), v.native(), i, i, i, i));
}

template <contact::detail::LaneSet set>
[[gnu::always_inline]] inline LanesOf<4, set> cross(const LanesOf<4, set>& a,
                                                    const LanesOf<4, set>& b) {
  const auto turned =
      [](const LanesOf<4, set>& v) __attribute__((always_inline)) {
    return LanesOf<4, set>(
        __builtin_shufflevector(v.native(), v.native(), 1, 2, 0, 3));
  };
  return turned(a * turned(b) - turned(a) * b);
}
template <contact::detail::LaneSet set>
[[gnu::always_inline]] inline double dot(const LanesOf<4, set>& a,
                                         const LanesOf<4, set>& b) {
  return reduce(a * b);
}

[[gnu::always_inline]] inline void load(const Padded& from, Vec3<double>& to) {
  to = vec3(from);
}
template <contact::detail::LaneSet set>
[[gnu::always_inline]] inline void load(const Padded& from,
                                        LanesOf<4, set>& to) {
  to = LanesOf<4, set>::load(&from.x);
}
[[gnu::always_inline]] inline void store(const Vec3<double>& from, Padded& to) {
  to = padded(from);
}
template <contact::detail::LaneSet set>
[[gnu::always_inline]] inline void store(const LanesOf<4, set>& from,
                                         Padded& to) {
  from.store(&to.x);
}
template <class V>
[[gnu::always_inline]] inline V vector(const Padded& from) {
  V v;
  load(from, v);
  return v;
}
template <class V>
[[gnu::always_inline]] inline void add(const V& change, Padded& to) {
  store(vector<V>(to) + change, to);
}

template <class V>
struct Columns {
  V x, y, z;
};
template <class V>
[[gnu::always_inline]] inline Columns<V> matrix(const PaddedMatrix& from) {
  return {vector<V>(from.x), vector<V>(from.y), vector<V>(from.z)};
}
template <class V>
[[gnu::always_inline]] inline void store(const Columns<V>& from,
                                         PaddedMatrix& to) {
  store(from.x, to.x);
  store(from.y, to.y);
  store(from.z, to.z);
}
template <class V>
[[gnu::always_inline]] inline void add(const Columns<V>& change,
                                       PaddedMatrix& to) {
  add(change.x, to.x);
  add(change.y, to.y);
  add(change.z, to.z);
}

/// m v, v in memory: each of its numbers goes to all lanes on the way.
template <class V, class Stored>
[[gnu::always_inline]] inline V times(const Columns<V>& m, const Stored& v) {
  return v.x * m.x + v.y * m.y + v.z * m.z;
}
template <contact::detail::LaneSet set>
[[gnu::always_inline]] inline LanesOf<4, set> times(
    const Columns<LanesOf<4, set>>& m, const LanesOf<4, set>& v) {
  return part<0>(v) * m.x + part<1>(v) * m.y + part<2>(v) * m.z;
}
/// m n
template <class V, class Matrix>
[[gnu::always_inline]] inline Columns<V> product(const Columns<V>& m,
                                                 const Matrix& n) {
  return {times(m, n.x), times(m, n.y), times(m, n.z)};
}
/// m n^T
template <class V>
[[gnu::always_inline]] inline Columns<V> product_transposed(
    const Columns<V>& m, const PaddedMatrix& n) {
  return {n.x.x * m.x + n.y.x * m.y + n.z.x * m.z,
          n.x.y * m.x + n.y.y * m.y + n.z.y * m.z,
          n.x.z * m.x + n.y.z * m.y + n.z.z * m.z};
}
template <class V>
[[gnu::always_inline]] inline Columns<V> operator+(const Columns<V>& m,
                                                   const Columns<V>& n) {
  return {m.x + n.x, m.y + n.y, m.z + n.z};
}
template <class V>
[[gnu::always_inline]] inline Columns<V> operator-(const Columns<V>& m,
                                                   const Columns<V>& n) {
  return {m.x - n.x, m.y - n.y, m.z - n.z};
}
template <class V>
[[gnu::always_inline]] inline Columns<V> scaled(double s, const Columns<V>& m) {
  return {s * m.x, s * m.y, s * m.z};
}
/// a b^T
template <class V>
[[gnu::always_inline]] inline Columns<V> outer(const V& a, const Padded& b) {
  return {b.x * a, b.y * a, b.z * a};
}
/// v~ m, v~ the cross-product matrix
template <class V>
[[gnu::always_inline]] inline Columns<V> crossed(const V& v,
                                                 const Columns<V>& m) {
  return {cross(v, m.x), cross(v, m.y), cross(v, m.z)};
}
/// m v~
template <class V>
[[gnu::always_inline]] inline Columns<V> crossed(const Columns<V>& m,
                                                 const Padded& v) {
  return {v.z * m.y - v.y * m.z, v.x * m.z - v.z * m.x, v.y * m.x - v.x * m.y};
}

[[gnu::always_inline]] inline Columns<Vec3<double>> transposed(
    const Columns<Vec3<double>>& m) {
  return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}};
}
template <contact::detail::LaneSet set>
[[gnu::always_inline]] inline Columns<LanesOf<4, set>> transposed(
    const Columns<LanesOf<4, set>>& m) {
  using V = LanesOf<4, set>;
  const auto x = m.x.native(), y = m.y.native(), z = m.z.native();
  const auto even = __builtin_shufflevector(x, y, 0, 4, 2, 6);
  const auto odd = __builtin_shufflevector(x, y, 1, 5, 3, 7);
  return {V(__builtin_shufflevector(even, z, 0, 1, 4, 7)),
          V(__builtin_shufflevector(odd, z, 0, 1, 5, 7)),
          V(__builtin_shufflevector(even, z, 2, 3, 6, 7))};
}
/// @tparam symmetric  m is
template <bool symmetric, class V>
[[gnu::always_inline]] inline Columns<V> inverse(const Columns<V>& m) {
  const V yz = cross(m.y, m.z);
  const Columns<V> rows = scaled(
      1 / dot(m.x, yz), Columns<V>{yz, cross(m.z, m.x), cross(m.x, m.y)});
  return symmetric ? rows : transposed(rows);
}

}  // namespace multibody::detail
