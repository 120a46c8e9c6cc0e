#pragma once

#include <Eigen/Core>

namespace contact {

/// |v| without overflow or underflow; NaN if a part is NaN or infinite.
///
/// The same bits wherever v lies: Eigen's stableNorm() groups its sum by the
/// alignment of v's address, so that equal loads of two callers differed in
/// their last digits.
inline double magnitude(const Eigen::Vector3d& v) {
  constexpr double safe = 1e140;
  const double plain = v.norm();
  if (plain > 1 / safe && plain < safe) return plain;
  const double largest = v.cwiseAbs().maxCoeff();
  return v.isZero(0) ? 0 : largest * (v / largest).norm();
}

}  // namespace contact
