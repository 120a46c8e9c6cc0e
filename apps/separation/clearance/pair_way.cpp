#include "separation/clearance/pair_way.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace separation {

double speed_bound(const multibody::BodyMotion& a,
                   const multibody::BodyMotion& b, double radius) {
  const Eigen::Vector3d apart = b.position - a.position;
  return (b.velocity - a.velocity - a.angular_velocity.cross(apart)).norm() +
         (b.angular_velocity - a.angular_velocity).norm() * radius;
}

void PairWay::move_on(double time,
                      std::span<const multibody::BodyMotion> bodies) {
  const multibody::BodyMotion& a = bodies[pair_.a];
  const multibody::BodyMotion& b = bodies[pair_.b];
  const Eigen::Vector3d apart = b.position - a.position;
  rotation_ = a.rotation.transpose() * b.rotation;
  place_ = a.rotation.transpose() * apart;
  // No point of a solid turns faster, or has turned farther, than one at its
  // radius; of a rotation's matrix 1/sqrt(2) of Frobenius' norm is the largest
  // stretch.
  const double speed = speed_bound(a, b, radius_);
  const double moved =
      (place_ - known_place_).norm() +
      (rotation_ - known_rotation_).norm() / std::sqrt(2.) * radius_;
  before_ = now_;
  now_ = known_ - moved;
  since_ = time_;
  way_ = (time - time_) * (std::max(speed, speed_) + std::abs(speed - speed_));
  time_ = time;
  speed_ = speed;
}

void PairWay::know(double distance) {
  known_ = now_ = std::isnan(distance) ? unknown : distance;
  known_rotation_ = rotation_;
  known_place_ = place_;
}

}  // namespace separation
