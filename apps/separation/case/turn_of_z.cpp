#include "separation/case/turn_of_z.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace separation {

// Eigen's Quaterniond::FromTwoVectors does the same at the price of a singular
// value decomposition in every file that calls it.
Eigen::Matrix3d turn_of_z(const Eigen::Vector3d& axis) {
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d to = axis.normalized();
  // Twice the cosine of half the angle.
  const double w = std::sqrt((1 + to.z()) * 2);
  // Next to -z the turn is half a one, about any axis across.
  if (!(w > 1e-7)) return Eigen::Vector3d(1, -1, -1).asDiagonal();
  Eigen::Quaterniond turn;
  turn.w() = w / 2;
  turn.vec() = z.cross(to) / w;
  return turn.toRotationMatrix();
}

}  // namespace separation
