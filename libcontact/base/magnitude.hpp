// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace contact {

namespace detail {

/// Whether squares of numbers of this size neither overflow nor vanish.
inline bool has_square(double size) {
  constexpr double safe = 1e140;
  return size > 1 / safe && size < safe;
}

}  // namespace detail

/// |v| without overflow or underflow; NaN if a part is NaN or infinite.
///
/// The same bits wherever v lies: Eigen's stableNorm() groups its sum by the
/// alignment of v's address, so that equal loads of two callers differed in
/// their last digits.
inline double magnitude(const Eigen::Vector3d& v) {
  const double plain = v.norm();
  if (detail::has_square(plain)) return plain;
  const double largest = v.cwiseAbs().maxCoeff();
  return v.isZero(0) ? 0 : largest * (v / largest).norm();
}

}  // namespace contact
