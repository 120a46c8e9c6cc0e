#include "libcontact/friction/special.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>

#include "libcontact/base/cancellation.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/friction/elliptic/integrals.hpp"
#include "libcontact/pressure/cosine.hpp"

namespace contact {
namespace {

using detail::all_nan;
using detail::pi;

FrictionTriple over(const FrictionTriple& f, double normal) {
  return {f.force / normal, f.sliding / normal, f.spinning / normal};
}

/// ∫ f(y) dy, 0 <= y <= 1, for functions with a logarithmic singularity at
/// `middle`, if that lies inside. The rule always sees [0, 1], whose nodes
/// are never rounded to an end.
template <class Function>
double integrate(Function f, double middle) {
  thread_local boost::math::quadrature::tanh_sinh<double> rule;
  if (!(middle < 1)) return rule.integrate(f, 0.0, 1.0);
  const double rest = 1 - middle;
  return middle *
             rule.integrate([&](double u) { return f(middle * u); }, 0.0, 1.0) +
         rest * rule.integrate([&](double u) { return f(middle + rest * u); },
                               0.0, 1.0);
}

/// s - d c - s^3/3, s = sin d, c = cos d: (2/15) d^5 as d -> 0.
double spin_moment(double d) {
  const double s = std::sin(d);
  if (d > 1) {
    // Two terms that cancel to a third at d = 1.
    return d * d * d * detail::sin_minus_x_cos_over_cube(d) - s * s * s / 3;
  }
  // = (3/4) sin d - d cos d + (1/12) sin 3d, whose series from k = 2 on is
  // the sum of (-1)^k ((9^k + 3)/4 - (2k + 1)) d^(2k+1)/(2k + 1)!; the term
  // k = 14 is 1e-18 of it at d = 1.
  double sum = 0;
  double power = d;  // (-1)^k d^(2k+1)/(2k + 1)!
  double nine = 1;   // 9^k
  for (int k = 1; k <= 14; ++k) {
    power *= -d * d / ((2 * k) * (2 * k + 1));
    nine *= 9;
    sum += ((nine + 3) / 4 - (2 * k + 1)) * power;  // 0 at k = 1
  }
  return sum;
}

}  // namespace

FrictionIntegrals sliding_friction_integrals(double half_angle) {
  if (!(half_angle >= 0 && half_angle <= pi)) return all_nan();
  FrictionIntegrals result{};
  if (half_angle == 0) {
    result.coefficient = {1, 1, 0};
    return result;
  }
  const double s = std::sin(half_angle), c = std::cos(half_angle);
  const double half = std::sin(half_angle / 2);
  const double rise = 2 * half * half;  // 1 - c
  // v = 1 - rise y; E and B as functions of x = v^2, singular at v = 0.
  const double middle = 1 / rise;
  const auto v = [=](double y) { return 1 - rise * y; };
  const auto e = [=](double y) { return elliptic_e(v(y) * v(y)); };
  const auto b = [=](double y) { return elliptic_k_cosine(v(y) * v(y)); };
  result.normal = cosine_normal_integral(JointKind::ball, half_angle);
  result.area = {4 * s * s * elliptic_k_cosine(c * c),
                 4 * rise * integrate(e, middle), 0};
  result.pressure = {
      4 * rise * rise *
          integrate([=](double y) { return y * (2 - rise * y) * b(y); },
                    middle),
      4 * rise * rise *
          integrate([=](double y) { return (1 - y) * e(y); }, middle),
      0};
  result.coefficient = over(result.pressure, result.normal);
  return result;
}

FrictionIntegrals spinning_friction_integrals(double half_angle) {
  if (!(half_angle >= 0 && half_angle <= pi)) return all_nan();
  FrictionIntegrals result{};
  if (half_angle == 0) return result;
  const double twice = 2 * half_angle;
  result.normal = cosine_normal_integral(JointKind::ball, half_angle);
  result.area.spinning =
      pi / 2 * twice * twice * twice * detail::x_minus_sin_over_cube(twice);
  result.pressure.spinning = pi * spin_moment(half_angle);
  result.coefficient = over(result.pressure, result.normal);
  return result;
}

FrictionIntegrals hemisphere_friction_integrals(SlipAxis axis) {
  if (std::isnan(axis.sin) || std::isnan(axis.cos)) return all_nan();
  const double x = axis.sin * axis.sin;
  const double b = elliptic_k_cosine(x), e = elliptic_e(x);
  FrictionIntegrals result;
  result.normal = 2 * pi / 3;
  result.pressure = {pi * pi / 4 * axis.cos, 4 * axis.cos * (b + e) / 3,
                     4 * axis.sin * e / 3};
  result.area = {4 * axis.cos * b, pi * pi / 2 * axis.cos,
                 pi * pi / 2 * axis.sin};
  result.coefficient = over(result.pressure, result.normal);
  return result;
}

}  // namespace contact
