#include "separation/clearance/solid.hpp"

#include <cmath>

#include "libcontact/base/linear/turn.hpp"

namespace separation {

using Eigen::Vector2d;
using Eigen::Vector3d;

Solid::Solid(const Shape& shape)
    : kind_(shape.kind),
      from_(shape.from),
      to_(shape.to),
      across_(Eigen::Matrix<double, 3, 2>::Zero()),
      radius_(shape.radius),
      points_(3, shape.points.size()),
      margin_(shape.kind == ShapeKind::capsule ? shape.radius : 0),
      reach_(separation::reach(shape)) {
  if (from_ != to_)
    across_ = contact::detail::turn_of_z(to_ - from_).leftCols<2>();
  Eigen::Index i = 0;
  for (const Vector3d& point : shape.points) points_.col(i++) = point;
}

Vector3d Solid::farthest(const Vector3d& direction) const {
  if (kind_ == ShapeKind::hull) {
    Eigen::Index i = 0;
    (direction.transpose() * points_).maxCoeff(&i);
    return points_.col(i);
  }
  const double along = direction.dot(to_ - from_);
  if (kind_ == ShapeKind::capsule) return along > 0 ? to_ : from_;
  // Two components, so that no rounding error leads out of the end's plane.
  const double x = direction.dot(across_.col(0));
  const double y = direction.dot(across_.col(1));
  const double length = std::hypot(x, y);
  const Vector3d rim =
      length > 0 ? Vector3d(across_ * Vector2d(x, y) * (radius_ / length))
                 : Vector3d::Zero();
  if (kind_ == ShapeKind::cylinder) return (along > 0 ? to_ : from_) + rim;
  return along > radius_ * length ? to_ : Vector3d(from_ + rim);
}

}  // namespace separation
