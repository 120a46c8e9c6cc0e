#include "libcontact/pressure/cosine.hpp"

#include <cmath>

#include "libcontact/base/cancellation.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/pressure/expansion.hpp"
#include "libcontact/pressure/registry.hpp"

namespace contact {
namespace {

using detail::nan;
using detail::pi;

bool is_half_angle(double half_angle) {
  return half_angle >= 0 && half_angle <= pi;
}

// (theta0 - s c)/theta0^3, from x - sin x at x = 2 theta0.
double pin_integral_over_cube(double half_angle) {
  return 4 * detail::x_minus_sin_over_cube(2 * half_angle);
}

// 2 + c = 3 - 2 sin^2(theta0/2)
double two_plus_cosine(double h) { return 3 - 2 * h * h; }

}  // namespace

double CosinePressure::peak(double half_angle) const noexcept {
  if (!is_half_angle(half_angle)) return nan;
  const double h = std::sin(half_angle / 2);
  if (joint_kind() == JointKind::ball) {
    return 3 / (2 * pi * two_plus_cosine(h)) / h / h;
  }
  const double ratio = half_angle == 0 ? 0.5 : h / half_angle;
  return 2 * ratio * ratio / pin_integral_over_cube(half_angle) / half_angle;
}

double CosinePressure::pressure(double theta,
                                double half_angle) const noexcept {
  if (std::isnan(theta) || !is_half_angle(half_angle)) return nan;
  const double t = std::abs(theta);
  if (t > half_angle) return 0;
  if (t == 0) return peak(half_angle);
  // (cos t - c)/(1 - c) = sin((theta0 + t)/2) sin((theta0 - t)/2)/h^2
  const double h = std::sin(half_angle / 2);
  return peak(half_angle) * (std::sin((half_angle + t) / 2) / h) *
         (std::sin((half_angle - t) / 2) / h);
}

double CosinePressure::slope(double theta, double half_angle) const noexcept {
  if (std::isnan(theta) || !is_half_angle(half_angle)) return nan;
  if (theta == 0 || std::abs(theta) > half_angle) return 0;
  // p0 sin t, p0 = peak/(2 h^2)
  const double h = std::sin(half_angle / 2);
  return peak(half_angle) * (std::sin(theta) / h) / (2 * h);
}

void CosinePressure::edge_slopes(double half_angle,
                                 std::span<const double> edge_variable,
                                 std::span<double> out) const noexcept {
  // p = peak x^2 C/(1 - h^2 x^2), C = cos^2(theta0/2)
  const double h = std::sin(half_angle / 2);
  const double c = std::cos(half_angle / 2);
  const double scale =
      is_half_angle(half_angle) ? 2 * peak(half_angle) * c * c : nan;
  for (std::size_t i = 0; i < edge_variable.size(); ++i) {
    const double x = edge_variable[i];
    const double rest = (1 - h * x) * (1 + h * x);
    out[i] = scale * x / (rest * rest);
  }
}

PressureExpansion CosinePressure::expansion(double half_angle) const noexcept {
  return {.cosine_share = is_half_angle(half_angle) ? 1 : nan};
}

double CosinePressure::force_ratio(double half_angle) const noexcept {
  if (!is_half_angle(half_angle)) return nan;
  if (joint_kind() == JointKind::ball) {
    return 3 / two_plus_cosine(std::sin(half_angle / 2));
  }
  return 2 * detail::sin_minus_x_cos_over_cube(half_angle) /
         pin_integral_over_cube(half_angle);
}

double CosinePressure::largest_half_angle() const noexcept { return pi; }

double cosine_normal_integral(JointKind kind, double half_angle) {
  if (!is_half_angle(half_angle)) return nan;
  if (kind == JointKind::ball) {
    const double h = std::sin(half_angle / 2);
    const double square = 2 * h * h;  // 1 - c
    return pi / 3 * square * square * two_plus_cosine(h);
  }
  return half_angle * half_angle * half_angle *
         pin_integral_over_cube(half_angle);
}

namespace detail {

extern constexpr PressureEntry cosine_pressure = {
    .about = {.name = "cosine",
              .meaning = "the paper's law (3.3)",
              .accuracy = "S 6 %, peak 33 %",
              .allows_back = true},
    .shape = "(cos t - c)/(1 - c)",
    .make = [](const PressureRequest& asked) -> std::unique_ptr<PressureLaw> {
      return std::make_unique<CosinePressure>(asked.kind);
    }};

}  // namespace detail
}  // namespace contact
