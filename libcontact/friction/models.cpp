#include "libcontact/friction/models.hpp"

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>

#include "libcontact/base/constants.hpp"
#include "libcontact/friction/elliptic/integrals.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/friction/special.hpp"
#include "libcontact/pressure/cosine.hpp"

namespace contact {
namespace {

using detail::all_nan;
using detail::pi;

bool is_half_angle(double theta0) { return theta0 >= 0 && theta0 <= pi; }

double one_minus_cosine(double theta) {
  const double s = std::sin(theta / 2);
  return 2 * s * s;
}

/// Gr(p, b) of the header, the first argument's component of the unit
/// vectors averaged over a ring; p, b >= 0.
double ring(double p, double b) {
  if (p == b) return 4;
  if (b < p) {
    const double ratio = b / p;
    return 4 * elliptic_e((1 - ratio) * (1 + ratio));
  }
  const double ratio = p / b;
  return 4 * ratio * elliptic_k_cosine((1 - ratio) * (1 + ratio));
}

/// Integrals over the colatitude t of f(t), from 0 to theta0, in pieces that
/// end where the ring passes through the pole, sin t = cot a.
template <class F>
double integrate(F f, double theta0, double pole) {
  static thread_local boost::math::quadrature::tanh_sinh<double> rule;
  // Square-root of rounding: tanh-sinh doubles its digits per level.
  constexpr double tolerance = 1e-9;
  double sum = 0;
  double left = 0;
  for (const double cut : {pole, pi - pole, theta0}) {
    const double right = std::min(cut, theta0);
    if (!(right > left)) continue;
    // On [-1, 1]: on other intervals this rule asserts that no node is
    // rounded to an end, which happens.
    const double middle = (left + right) / 2;
    const double half = (right - left) / 2;
    sum += half * rule.integrate([&](double x) { return f(middle + half * x); },
                                 tolerance);
    left = right;
  }
  return sum;
}

FrictionTriple times(FrictionTriple x, double along, double across) {
  return {x.force * along, x.sliding * along, x.spinning * across};
}

}  // namespace

FrictionIntegrals planar_friction_integrals(double half_angle, SlipAxis axis) {
  const double sa = std::abs(axis.sin);
  const double q = axis.cos;
  if (!is_half_angle(half_angle) || std::isnan(sa) || std::isnan(q)) {
    return all_nan();
  }
  FrictionIntegrals result{};
  if (half_angle == 0) {
    const double along = q > 0 ? 1 : 0;
    result.coefficient = {along, along, 0};
    return result;
  }
  const double pole = sa > q ? std::asin(q / sa) : pi / 2;
  const auto slide = [&](double t) {
    return ring(q, sa * std::sin(t)) * std::sin(t);
  };
  const auto spin = [&](double t) {
    const double s = std::sin(t);
    return ring(sa * s, q) * s * s;
  };
  // cos t - cos theta0 without cancellation.
  const auto weight = [&](double t) {
    return 2 * std::sin((half_angle + t) / 2) * std::sin((half_angle - t) / 2);
  };
  const auto over = [&](auto f) { return integrate(f, half_angle, pole); };
  result.normal = cosine_normal_integral(JointKind::ball, half_angle);
  result.area = {over(slide),
                 over([&](double t) { return slide(t) * std::cos(t); }),
                 std::copysign(over(spin), axis.sin)};
  result.pressure = {
      over([&](double t) { return weight(t) * slide(t); }),
      over([&](double t) { return weight(t) * slide(t) * std::cos(t); }),
      std::copysign(over([&](double t) { return weight(t) * spin(t); }),
                    axis.sin)};
  const double inverse = 1 / result.normal;
  result.coefficient = times(result.pressure, inverse, inverse);
  return result;
}

FrictionIntegrals viscous_friction_integrals(double half_angle, SlipAxis axis) {
  if (!is_half_angle(half_angle)) return all_nan();
  const double u = one_minus_cosine(half_angle);
  const double s = std::sin(half_angle);
  const FrictionTriple area{pi * s * s, pi * u * (2 - u + u * u / 3),
                            2 * pi * u * u * (1 - u / 3)};
  // Over (pi/3) u^2 (3 - u); finite at u = 0.
  const FrictionTriple coefficient{1, 3 * (1 - u / 3 + u * u / 12) / (3 - u),
                                   u * (2 - u / 2) / (3 - u)};
  FrictionIntegrals result;
  result.normal = cosine_normal_integral(JointKind::ball, half_angle);
  result.area = times(area, axis.cos, axis.sin);
  result.coefficient = times(coefficient, axis.cos, axis.sin);
  result.pressure = times(result.coefficient, result.normal, result.normal);
  return result;
}

FrictionIntegrals cosine_friction_integrals(double half_angle, SlipAxis axis) {
  const FrictionIntegrals slide =
      friction_integrals(half_angle, SlipAxis{0, 1});
  const FrictionIntegrals spin = friction_integrals(half_angle, SlipAxis{1, 0});
  const auto mix = [&](const FrictionTriple& sliding,
                       const FrictionTriple& spinning) {
    return times({sliding.force, sliding.sliding, spinning.spinning}, axis.cos,
                 axis.sin);
  };
  return {slide.normal, mix(slide.pressure, spin.pressure),
          mix(slide.area, spin.area), mix(slide.coefficient, spin.coefficient)};
}

}  // namespace contact
