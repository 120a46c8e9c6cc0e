#include "libcontact/conforming/pin_closed_form.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <utility>

#include "libcontact/base/check.hpp"
#include "libcontact/base/constants.hpp"

namespace contact {
namespace {

using detail::infinity;
using detail::nan;
using detail::pi;

// ln(1+B) + 2 B^2
double outer_part(double b2) { return std::log1p(b2) + 2 * b2 * b2; }

}  // namespace

PinClosedForm::PinClosedForm(double outer_compliance_share)
    : outer_share_(outer_compliance_share) {
  detail::require(outer_compliance_share >= 0 && outer_compliance_share <= 1,
                  "closed form of a pin", "outer_compliance_share",
                  outer_compliance_share, "0 to 1");
  limit_ = half_angle(infinity).half_angle;
}

double PinClosedForm::reciprocal_load(double half_angle) const noexcept {
  if (!(half_angle > 0 && half_angle < pi)) return nan;
  const double b = std::tan(half_angle / 2);
  const double b2 = b * b;
  return (1 - outer_share_ * outer_part(b2)) / (b2 * (1 + b2));
}

ExactLoad PinClosedForm::load_parameter(double half_angle) const noexcept {
  if (half_angle == 0) return {0, Status::ok, 0};
  if (half_angle == limit_) return {infinity, Status::ok, 0};
  const double reciprocal = reciprocal_load(half_angle);
  if (!(reciprocal > 0)) return {nan, Status::out_of_range, nan};
  return {1 / reciprocal, Status::ok, 0};
}

ExactHalfAngle PinClosedForm::half_angle(double load_parameter) const noexcept {
  if (!(load_parameter >= 0)) return {nan, Status::out_of_range, nan, 0};
  if (load_parameter == 0) return {0, Status::ok, 0, 0};
  const double lambda = load_parameter;
  // f(B) = 1 - w_2 (ln(1+B) + 2 B^2) - B (1+B)/lambda falls and is concave:
  // from an upper bound of the root Newton's method descends to it. Each of
  // its two falling parts alone bounds the root.
  const double high = std::min(
      std::isinf(lambda) ? infinity
                         : 2 * lambda / (1 + std::sqrt(1 + 4 * lambda)),
      1 / std::sqrt(2 * outer_share_));
  if (std::isinf(high)) return {pi, Status::ok, 0, 0};
  int evaluations = 0;
  const auto f = [&](double b2) {
    ++evaluations;
    return std::pair(
        1 - outer_share_ * outer_part(b2) - b2 * (1 + b2) / lambda,
        -outer_share_ * (1 / (1 + b2) + 4 * b2) - (1 + 2 * b2) / lambda);
  };
  // Five to seven steps; full accuracy is 53 bits.
  constexpr std::uintmax_t step_limit = 60;
  std::uintmax_t steps = step_limit;
  const double b2 =
      boost::math::tools::newton_raphson_iterate(f, high, 0.0, high, 53, steps);
  return {2 * std::atan(std::sqrt(b2)),
          steps < step_limit ? Status::ok : Status::not_converged, 0,
          evaluations};
}

double PinClosedForm::pressure(double theta, double half_angle) noexcept {
  if (!(half_angle > 0 && half_angle < pi)) return nan;
  theta = std::abs(theta);
  if (theta >= half_angle) return 0;
  const double sine = std::sin(half_angle / 2);
  const double cosine = std::cos(half_angle / 2);
  const double edge =
      std::sin((half_angle - theta) / 2) * std::sin((half_angle + theta) / 2);
  // With y = tan(theta/2): s1 = sqrt(b^2 + 1), s2 = sqrt(b^2 - y^2),
  // ratio = s2/s1.
  const double cosine_theta = std::cos(theta / 2);
  const double ratio = std::sqrt(edge) / cosine_theta;
  const double cosine2 = cosine * cosine;
  return 2 / pi * ratio * cosine_theta * cosine_theta +
         std::atanh(ratio) * cosine2 * cosine2 / (pi * sine * sine);
}

double PinClosedForm::force_ratio(double half_angle) noexcept {
  if (!(half_angle >= 0 && half_angle < pi)) return nan;
  const double b = std::tan(half_angle / 2);
  const double b2 = b * b;
  if (b2 == 0) return 1;
  return outer_part(b2) / (b2 * (1 + b2));
}

}  // namespace contact
