#include "libcontact/base/linear/turn.hpp"

namespace contact::detail {

using Eigen::Quaterniond;
using Eigen::Vector3d;

// Eigen's Quaterniond::FromTwoVectors does the same at the price of a singular
// value decomposition in every file that calls it: 4 s of compiling.
Quaterniond turn_between(const Vector3d& from, const Vector3d& to) {
  const Vector3d a = from.normalized(), b = to.normalized();
  // Twice the cosine of half the angle.
  const double w = (a + b).norm();
  Quaterniond turn;
  if (w > 1e-7) {
    turn.w() = w / 2;
    turn.vec() = a.cross(b) / w;
    turn.normalize();  // the product rounds where both are nearly opposite
  } else {
    turn.w() = 0;
    turn.vec() = a.unitOrthogonal().cross(a);
  }
  return turn;
}

Eigen::Matrix3d turn_of_z(const Vector3d& to) {
  return turn_between(Vector3d::UnitZ(), to).toRotationMatrix();
}

}  // namespace contact::detail
