#include "libcontact/pressure/worn.hpp"

#include <cmath>

#include "libcontact/base/constants.hpp"
#include "libcontact/pressure/cosine.hpp"
#include "libcontact/pressure/expansion.hpp"
#include "libcontact/pressure/registry.hpp"

namespace contact {
namespace {

using detail::nan;
using detail::pi;

}  // namespace

double WornPressure::largest_half_angle() const noexcept { return pi / 2; }

double WornPressure::peak(double half_angle) const noexcept {
  if (!has(half_angle)) return nan;
  const double c = std::cos(half_angle);
  if (joint_kind() == JointKind::pin) {
    return 1 / (half_angle + std::sin(half_angle) * c);
  }
  const double h = std::sin(half_angle / 2);
  return 3 / (4 * pi * h * h * (1 + c + c * c));
}

double WornPressure::pressure(double theta, double half_angle) const noexcept {
  if (std::isnan(theta) || !has(half_angle)) return nan;
  if (std::abs(theta) > half_angle) return 0;
  return peak(half_angle) * std::cos(theta);
}

double WornPressure::slope(double theta, double half_angle) const noexcept {
  if (std::isnan(theta) || !has(half_angle)) return nan;
  if (theta == 0 || std::abs(theta) > half_angle) return 0;
  return peak(half_angle) * std::sin(theta);
}

void WornPressure::edge_slopes(double half_angle,
                               std::span<const double> edge_variable,
                               std::span<double> out) const noexcept {
  // tan^2(theta/2) = b^2 (1 - x^2), cos theta = 2/(1 + tan^2) - 1
  const double b = std::tan(half_angle / 2);
  const double scale = has(half_angle) ? 4 * peak(half_angle) * b * b : nan;
  for (std::size_t i = 0; i < edge_variable.size(); ++i) {
    const double x = edge_variable[i];
    const double rest = 1 + b * b * (1 - x) * (1 + x);
    out[i] = scale * x / (rest * rest);
  }
}

double WornPressure::force_ratio(double half_angle) const noexcept {
  if (!has(half_angle)) return nan;
  if (half_angle == 0) return 1;
  const double s = std::sin(half_angle);
  return peak(half_angle) *
         (joint_kind() == JointKind::pin ? 2 * s : pi * s * s);
}

PressureExpansion WornPressure::expansion(double half_angle) const noexcept {
  if (!has(half_angle)) return {.cosine_share = nan};
  if (half_angle == 0) return {.cosine_share = 1};
  const double p = peak(half_angle);
  return {.cosine_share = p * cosine_normal_integral(joint_kind(), half_angle),
          .edge_pressure = p * std::cos(half_angle)};
}

namespace detail {

extern constexpr PressureEntry worn_pressure = {
    .about = {.name = "worn",
              .meaning = "a seat or hole that has worn in; up to 90 deg",
              .accuracy = "of another surface",
              .allows_back = true,
              .allows_walls = true,
              .least_clearance = Clearance::positive,
              .is_among_all = false},
    .shape = "cos t",
    .make = [](const PressureRequest& asked) -> std::unique_ptr<PressureLaw> {
      return std::make_unique<WornPressure>(asked.kind);
    }};

}  // namespace detail
}  // namespace contact
