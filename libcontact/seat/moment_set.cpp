#include "libcontact/seat/moment_set.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <limits>

#include "libcontact/joint/motion_left.hpp"
#include "libcontact/seat/joint.hpp"
#include "libcontact/seat/seat_work.hpp"

namespace contact {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

SeatMomentSet::SeatMomentSet(const SeatJoint& joint,
                             std::shared_ptr<const detail::SeatWork> contact)
    : joint_(&joint),
      contact_(std::move(contact)),
      has_contact_(contact_->state.status == SeatStatus::ok &&
                   !joint.joint_.contact().is_viscous()) {}

double SeatMomentSet::support(const Vector3d& angular_velocity) const {
  if (angular_velocity.isZero(0)) return has_contact_ ? 0 : nan;
  return -moment(angular_velocity).dot(angular_velocity);
}

Vector3d SeatMomentSet::moment(const Vector3d& angular_velocity) const {
  if (!has_contact_ || angular_velocity.isZero(0)) {
    return Vector3d::Constant(nan);
  }
  const Matrix3d& axes = joint_->from_seat_;
  const Vector3d rate = axes.transpose() * angular_velocity.normalized();
  return axes * joint_->friction(*contact_, rate).moment;
}

// By central differences: the friction of the harmonics is smooth.
Matrix3d SeatMomentSet::curvature(const Vector3d& direction) const {
  constexpr double step = 1e-4;
  Matrix3d slope;
  for (int k = 0; k < 3; ++k) {
    const Vector3d by = step * Vector3d::Unit(k);
    slope.col(k) =
        (moment(direction - by) - moment(direction + by)) / (2 * step);
  }
  return (slope + slope.transpose()) / 2;
}

// The edge's normal where it opposes M: the unit vector u for which
// Phi(u)/(M.u) is least, which is a convex function of what u has across M.
Vector3d SeatMomentSet::normal(const Vector3d& moment_held) const {
  const Vector3d along = moment_held.normalized();
  Eigen::Matrix<double, 3, 2> across;
  across.col(0) = along.unitOrthogonal();
  across.col(1) = along.cross(across.col(0));
  Vector3d u = along;
  double least = support(u);
  for (int round = 0; round < 40; ++round) {
    const Vector2d slope = -across.transpose() * moment(u);
    if (!(slope.norm() > 1e-13 * least)) break;
    const Matrix3d second = curvature(u.normalized()) / u.norm();
    Vector3d step =
        -across * (across.transpose() * second * across).ldlt().solve(slope);
    if (!(step.dot(across * slope) < 0)) step = -across * slope / least;
    double share = 1;
    while (share > 1e-10 && !(support(u + share * step) < least)) share /= 2;
    if (share <= 1e-10) break;
    u += share * step;
    least = support(u);
  }
  return u.normalized();
}

double SeatMomentSet::utilisation(const Vector3d& moment_held) const {
  if (moment_held.isZero(0)) return has_contact_ ? 0 : nan;
  const Vector3d u = normal(moment_held);
  return moment_held.dot(u) / support(u);
}

Vector3d SeatMomentSet::project(const Vector3d& moment_held) const {
  return -prox(Matrix3d::Identity(), moment_held).moment;
}

MomentSet::Prox SeatMomentSet::prox(const Matrix3d& inertia,
                                    const Vector3d& free) const {
  const Vector3d wanted = inertia * free;
  if (!has_contact_ || !wanted.allFinite()) {
    return {Vector3d::Constant(nan), Vector3d::Constant(nan),
            Status::out_of_range, 0, nan};
  }
  const Vector3d u = wanted.isZero(0) ? wanted : normal(wanted);
  if (wanted.dot(u) <= support(u)) {
    return {Vector3d::Zero(), -wanted, Status::ok, 0, 0};
  }
  return detail::motion_left(
      [&](const Vector3d& v) { return moment(v); },
      [&](const Vector3d& v, const Vector3d&) { return curvature(v); }, inertia,
      free, u);
}

}  // namespace contact
