#include "libcontact/half_angle/worn.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "libcontact/base/check.hpp"
#include "libcontact/base/constants.hpp"

namespace contact {
namespace {

using detail::nan;
constexpr double right_angle = std::numbers::pi / 2;

// tan x - x
double tangent_less_angle(double x) {
  constexpr double small = 0.1;  // leaves 1e-15 of it
  if (x >= small) return std::tan(x) - x;
  const double t = x * x;
  return x * t *
         (1. / 3 +
          t * (2. / 15 + t * (17. / 315 + t * (62. / 2835 +
                                               t * (1382. / 155925 +
                                                    t * (21844. / 6081075))))));
}

// Newton's steps in the tangent, whose function is convex: from above.
double angle_of_tangent_less(double difference) {
  if (difference == 0) return 0;
  double tangent =
      difference + std::min(right_angle, std::cbrt(3 * difference));
  for (int i = 0; i < 50; ++i) {
    const double excess = tangent_less_angle(std::atan(tangent)) - difference;
    const double step = excess * (1 + 1 / (tangent * tangent));
    tangent -= step;
    if (std::abs(step) <= 1e-15 * tangent) break;
  }
  return std::atan(tangent);
}

// dg/d theta
double overlap_slope(JointKind kind, double theta) {
  const double tangent = std::tan(theta);
  if (kind == JointKind::pin) return tangent * tangent;
  // (1 - c)(1 + c) s/c^2 = s tan^2
  return std::sin(theta) * tangent * tangent;
}

}  // namespace

WornHalfAngle::WornHalfAngle(std::shared_ptr<const HalfAngleLaw> law,
                             double wear_number)
    : HalfAngleLaw(law->joint_kind(), law->made_for()),
      law_(std::move(law)),
      wear_number_(wear_number) {
  detail::require(detail::is_not_negative(wear_number), "worn half-angle",
                  "wear_number", wear_number, "0 or above and finite");
}

double WornHalfAngle::unit_volume(const JointGeometry& geometry) {
  const double size = geometry.radius() * geometry.radial_clearance();
  return geometry.kind() == JointKind::ball
             ? std::numbers::pi * geometry.radius() * size
             : 2 * geometry.length() * size;
}

double WornHalfAngle::overlap(JointKind kind, double half_angle) {
  if (!(half_angle >= 0 && half_angle < right_angle)) return nan;
  if (kind == JointKind::pin) return tangent_less_angle(half_angle);
  const double h = std::sin(half_angle / 2);
  return 4 * h * h * h * h / std::cos(half_angle);
}

double WornHalfAngle::half_angle_of_overlap(JointKind kind, double overlap) {
  if (!(overlap >= 0)) return nan;
  if (kind == JointKind::pin) return angle_of_tangent_less(overlap);
  // 1 - c
  const double rise = 1 / (std::sqrt(1 / overlap + 0.25) + 0.5);
  return 2 * std::asin(std::sqrt(rise / 2));
}

HalfAngleResult WornHalfAngle::half_angle(
    double load_parameter) const noexcept {
  // A seat that is pressed all round wears in another way.
  if (!(load_parameter >= 0)) return {nan, Status::out_of_range, nan};
  const HalfAngleResult fresh = law_->half_angle(load_parameter);
  const double g = overlap(joint_kind(), fresh.half_angle);
  if (fresh.status != Status::ok || std::isnan(g)) {
    return {nan, Status::out_of_range, nan};
  }
  if (wear_number_ == 0) return fresh;
  const double worn = half_angle_of_overlap(joint_kind(), g + wear_number_);
  return {worn, Status::ok,
          fresh.log_slope * fresh.half_angle / worn *
              overlap_slope(joint_kind(), fresh.half_angle) /
              overlap_slope(joint_kind(), worn)};
}

LoadParameterResult WornHalfAngle::load_parameter(
    double half_angle) const noexcept {
  const double g = overlap(joint_kind(), half_angle) - wear_number_;
  if (!(g >= 0)) return {nan, Status::out_of_range};
  return law_->load_parameter(half_angle_of_overlap(joint_kind(), g));
}

double WornHalfAngle::limit_half_angle() const noexcept {
  const double limit = law_->limit_half_angle();
  if (limit >= right_angle) return right_angle;
  return half_angle_of_overlap(joint_kind(),
                               overlap(joint_kind(), limit) + wear_number_);
}

std::vector<std::string> WornHalfAngle::validity_notes(
    const ElasticPair& pair) const {
  return law_->validity_notes(pair);
}

}  // namespace contact
