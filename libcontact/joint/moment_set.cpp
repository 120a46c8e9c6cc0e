#include "libcontact/joint/moment_set.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/root_finding.hpp"
#include "libcontact/joint/contact_model.hpp"
#include "libcontact/joint/motion_left.hpp"

namespace contact {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

using detail::infinity;
using detail::nan;

// A vector about n: length and direction of its part normal to n (any such
// direction where it has none), and its part along n.
struct Split {
  double across;
  Vector3d direction;
  double along;

  Split(const Vector3d& v, const Vector3d& n) : along(v.dot(n)) {
    // At right angles to n even where little but rounding is left.
    const Vector3d cross = n.cross(v);
    across = cross.norm();
    direction =
        across > 0 ? Vector3d(cross.cross(n) / across) : n.unitOrthogonal();
  }
};

SlipAxis axis_of(const Split& rate) {
  const double length = std::hypot(rate.across, rate.along);
  return {rate.along / length, rate.across / length};
}

SlipAxis from_cotangent(double cotangent) {
  const double length = std::hypot(1, cotangent);
  return {1 / length, cotangent / length};
}

}  // namespace

MomentSet::MomentSet(const JointContact& contact, const Vector3d& normal,
                     double normal_force, double half_angle) noexcept
    : contact_(&contact),
      // Without load every axis is alike.
      normal_(normal.isZero(0) ? Vector3d::UnitZ() : normal),
      normal_force_(normal_force),
      half_angle_(half_angle) {
  radius_ = contact.geometry().radius();
  const FrictionStress* stress = contact.stress();
  if (stress && stress->over_speed() == FrictionStress::OverSpeed::falls) {
    radius_ = nan;
  }
}

MomentSet::MomentSet(
    const JointContact& contact,
    std::shared_ptr<const detail::ContactMoments> moments) noexcept
    : MomentSet(contact, Vector3d::Constant(nan), nan, nan) {
  moments_ = std::move(moments);
}

MomentSet::Edge MomentSet::edge(SlipAxis axis) const noexcept {
  const FrictionTriple t =
      contact_->friction_at(half_angle_, axis, {normal_force_, 0});
  return {radius_ * t.sliding, radius_ * t.spinning};
}

double MomentSet::support(const Vector3d& angular_velocity) const noexcept {
  if (angular_velocity.isZero(0)) return 0;
  if (moments_) return -moment(angular_velocity).dot(angular_velocity);
  const SlipAxis axis = axis_of(Split(angular_velocity, normal_));
  const Edge e = edge(axis);
  return angular_velocity.norm() *
         (e.sliding * axis.cos + e.spinning * axis.sin);
}

Vector3d MomentSet::moment(const Vector3d& angular_velocity) const noexcept {
  if (angular_velocity.isZero(0)) return Vector3d::Constant(nan);
  if (moments_) {
    if (contact_->is_viscous()) return Vector3d::Zero();
    return moments_->moment(angular_velocity);
  }
  const Split split(angular_velocity, normal_);
  const Edge e = edge(axis_of(split));
  return -e.sliding * split.direction - e.spinning * normal_;
}

// The slip axis whose point of the edge lies in the direction of a moment,
// both parts >= 0 and not both 0. sliding/spinning of the edge grows with
// cot a, since the set is convex.
SlipAxis MomentSet::axis_of_moment(double sliding,
                                   double spinning) const noexcept {
  if (spinning == 0) return {0, 1};
  if (sliding == 0) return {1, 0};
  const auto residual = [&](double cotangent) {
    const Edge e = edge(from_cotangent(cotangent));
    return e.sliding * spinning - e.spinning * sliding;
  };
  // Exact if the edge were an ellipse.
  const double ratio = edge({1, 0}).spinning / most_sliding();
  const double guess = sliding / spinning * ratio * ratio;
  constexpr double factor = 1.5;  // growth of the bounds in their search
  std::uintmax_t steps = 200;     // 10 on average
  const auto [low, high] = boost::math::tools::bracket_and_solve_root(
      residual, guess, factor, true,
      boost::math::tools::eps_tolerance<double>(50), steps, NoThrow());
  return from_cotangent(low + (high - low) / 2);
}

// The edge's normal where it opposes M, of a set that is not round: the unit
// vector u for which Phi(u)/(M.u) is least, a convex function of the part of u
// across M.
Vector3d MomentSet::normal_at(const Vector3d& held) const noexcept {
  const Vector3d along = held.normalized();
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
        -across * (across.transpose() * second * across).inverse() * slope;
    if (!(step.dot(across * slope) < 0)) step = -across * slope / least;
    double share = 1;
    while (share > 1e-10 && !(support(u + share * step) < least)) share /= 2;
    if (share <= 1e-10) break;
    u += share * step;
    least = support(u);
  }
  return u.normalized();
}

double MomentSet::utilisation(const Vector3d& moment) const noexcept {
  if (moment.isZero(0)) return 0;
  if (moments_) {
    if (!moment.allFinite()) return nan;
    const Vector3d u = normal_at(moment);
    return moment.dot(u) / support(u);
  }
  const Split m(moment, normal_);
  const double spinning = std::abs(m.along);
  if (!(std::isfinite(m.across) && std::isfinite(spinning))) return nan;
  if (most_sliding() == 0) return infinity;
  const Edge e = edge(axis_of_moment(m.across, spinning));
  // Along the moment: exact where one part of it is 0.
  return (m.across * m.across + spinning * spinning) /
         (e.sliding * m.across + e.spinning * spinning);
}

Vector3d MomentSet::project(const Vector3d& moment) const noexcept {
  return -prox(Matrix3d::Identity(), moment).moment;
}

Matrix3d MomentSet::curvature(const Vector3d& direction) const noexcept {
  return curvature(direction, moment(direction));
}

Matrix3d MomentSet::curvature(const Vector3d& direction,
                              const Vector3d& moment_there) const noexcept {
  if (moments_) return curvature_of_any(direction);
  const Split split(direction, normal_);
  const SlipAxis axis = axis_of(split);
  const double sin_a = std::abs(axis.sin);
  const double cos_a = std::max(axis.cos, 1e-100);
  // At the pole nothing but rounding is left of a moment's part along the slip.
  constexpr double pole = 1e-6;
  const Edge e = cos_a > pole ? Edge{-moment_there.dot(split.direction),
                                     std::abs(moment_there.dot(normal_))}
                              : edge({sin_a, cos_a});
  // Along the meridian by a difference, central in its middle; the edge
  // changes over angles of cos a or theta0, whichever is larger.
  const double step =
      1e-5 * std::max(cos_a, std::min(1.0, std::abs(half_angle_)));
  const double cosine = std::cos(step);
  const double sine = std::sin(step);
  const Edge next =
      edge({sin_a * cosine - cos_a * sine, cos_a * cosine + sin_a * sine});
  const double half_sine = std::sin(step / 2);
  const double half_cosine = std::cos(step / 2);
  const double meridian =
      ((e.spinning - next.spinning) *
           (cos_a * half_cosine + sin_a * half_sine) -
       (e.sliding - next.sliding) * (sin_a * half_cosine - cos_a * half_sine)) /
      step;
  const double parallel = e.sliding / cos_a;
  const Vector3d along = axis.cos * normal_ - axis.sin * split.direction;
  const Vector3d across = normal_.cross(split.direction);
  return meridian * along * along.transpose() +
         parallel * across * across.transpose();
}

// By central differences: the friction of a contact at a rim is smooth.
Matrix3d MomentSet::curvature_of_any(const Vector3d& direction) const noexcept {
  constexpr double step = 1e-4;
  Matrix3d slope;
  for (int k = 0; k < 3; ++k) {
    const Vector3d by = step * Vector3d::Unit(k);
    slope.col(k) =
        (moment(direction - by) - moment(direction + by)) / (2 * step);
  }
  return (slope + slope.transpose()) / 2;
}

MomentSet::Prox MomentSet::prox(const Matrix3d& inertia, const Vector3d& free,
                                const Vector3d& guess) const noexcept {
  const Vector3d wanted = inertia * free;
  const double size = wanted.norm();
  if (!std::isfinite(size)) {
    return {Vector3d::Constant(nan), Vector3d::Constant(nan),
            Status::out_of_range, 0, nan};
  }
  const auto slide = [&](const Vector3d& u) {
    return detail::motion_left(
        [&](const Vector3d& v) { return moment(v); },
        [&](const Vector3d& v, const Vector3d& m) { return curvature(v, m); },
        inertia, free, u);
  };
  if (moments_) {
    const Vector3d u = size == 0 ? wanted : normal_at(wanted);
    if (wanted.dot(u) <= support(u)) {
      return {Vector3d::Zero(), -wanted, Status::ok, 0, 0};
    }
    return slide(u);
  }
  // Try a plane that separates W free from the set: then the joint slides.
  const Vector3d likely = guess.stableNormalized();
  const double least = support(likely);
  if (least > 0 && likely.dot(wanted) > least * (1 + 1e-6)) {
    return slide(likely);
  }
  if (size == 0 || utilisation(wanted) <= 1) {
    return {Vector3d::Zero(), -wanted, Status::ok, 0, 0};
  }
  if (most_sliding() == 0) {  // no friction
    return {free, Vector3d::Zero(), Status::ok, 0, 0};
  }
  // In the direction in which the set's edge opposes W free.
  const Split split(wanted, normal_);
  const SlipAxis start = axis_of_moment(split.across, std::abs(split.along));
  const Vector3d u = start.cos * split.direction +
                     std::copysign(start.sin, split.along) * normal_;
  return slide(u);
}

}  // namespace contact
