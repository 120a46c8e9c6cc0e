#include "multibody/friction/stop_cone.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "multibody/system/hinges/ball.hpp"

namespace multibody {

using Eigen::Map;
using Eigen::Vector3d;

namespace {

Map<Vector3d> rate_at(double* s) { return Map<Vector3d>(s + 4); }

}  // namespace

Vector3d StopCone::parent(const double* s) const {
  return rotation_at(s).transpose() * parent_;
}

StopCone::Turn StopCone::turn(const double* s) const {
  const Vector3d p = parent(s);
  const Vector3d w = BallHinge::rate(s);
  const Vector3d normal = p.cross(body_);
  const double sine = normal.norm();
  const Vector3d n = normal / sine;
  const double rate = n.dot(w);
  const double across = w.squaredNorm() - rate * rate;
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
  return {n, std::abs(rate) <= rounding * w.norm() ? 0 : rate,
          (across * p.dot(body_) - w.dot(p) * w.dot(body_)) / sine};
}

// By chords, 2 sin(psi/2) = |p - b| and 2 cos(psi/2) = |p + b|, because cosines
// of small angles, and of angles near pi, lose digits.
double StopCone::gap(const HingeStop& stop, const double* s) const {
  const Vector3d p = parent(s);
  const bool is_wide = stop.angle > std::numbers::pi / 2;
  const double half =
      is_wide ? std::cos(stop.angle / 2) : std::sin(stop.angle / 2);
  const double chord = is_wide ? (p + body_).norm() : (p - body_).norm();
  const double more = (chord - 2 * half) * (chord + 2 * half);
  return stop.side * (is_wide ? -more : more) / (2 * std::sin(stop.angle));
}

void StopCone::put_on(const HingeStop& stop, double* s) const {
  const Vector3d p = parent(s);
  const Vector3d normal = p.cross(body_);
  const double more = stop.angle - std::atan2(normal.norm(), p.dot(body_));
  const Eigen::Quaterniond turned =
      Eigen::Quaterniond(s[0], s[1], s[2], s[3]) *
      Eigen::Quaterniond(Eigen::AngleAxisd(more, normal.normalized()));
  Map<Eigen::Vector4d>{s} =
      Eigen::Vector4d(turned.w(), turned.x(), turned.y(), turned.z())
          .normalized();
}

void StopCone::stop_rate(double* s) const {
  const Vector3d n = turn(s).axis;
  rate_at(s) -= n.dot(rate_at(s)) * n;
}

}  // namespace multibody
