#pragma once

#include <cmath>
#include <numbers>

#include "libcontact/detail/cap_integrals.hpp"
#include "libcontact/friction_integrals.hpp"

namespace contact::detail {

/// One contact and slip axis, ready for the kernel.
struct PreparedCap {
  CapPoint<double> point;
  int rule;
  bool pole_inside;
  bool beyond_hemisphere;  ///< half-angle above 90 degrees: reflected
  ArcRange range;
};

inline PreparedCap prepare(double half_angle, SlipAxis axis) {
  PreparedCap cap;
  // NaN compares false: outside [0, pi] everything becomes NaN.
  const double theta0 = half_angle >= 0 && half_angle <= std::numbers::pi
                            ? half_angle
                            : std::nan("");
  const double s = std::sin(theta0);
  const double cosine = std::cos(theta0);
  const double c = std::abs(cosine);
  const double sa = std::abs(axis.sin);
  const double q = axis.cos;
  // q^2 - s^2 without cancellation: by the smaller pair of legs.
  const double difference =
      c < 0.7 && sa < 0.7 ? (c - sa) * (c + sa) : (q - s) * (q + s);
  const bool inside = difference <= 0;
  const double numerator = inside ? q : s;
  const double denominator = inside ? s : q;
  // A contact of no size: theta0 = 0 with any axis.
  const double inverse = denominator == 0 ? 0.0 : 1 / denominator;
  const double k = numerator * inverse;
  const double m =
      denominator == 0 ? 1.0 : std::abs(difference) * inverse * inverse;
  cap.point = {s, c, axis.sin, q, k * k, m};
  cap.rule = cap_rule_index(m);
  cap.pole_inside = inside;
  cap.beyond_hemisphere = cosine < 0;
  cap.range = c >= small_range_cosine    ? ArcRange::small
              : c >= medium_range_cosine ? ArcRange::medium
                                         : ArcRange::large;
  return cap;
}

/// Puts back the powers of s and q, reflects half-angles above 90 degrees.
inline FrictionIntegrals assemble(const PreparedCap& cap,
                                  const CapSums<double>& sum) {
  constexpr double pi = std::numbers::pi;
  const CapPoint<double>& p = cap.point;
  const double k = std::sqrt(p.k2);
  // q min(1, z)/s and |sin a| min(1, z): the ranges of phi end at asin z.
  const double along = cap.pole_inside ? k : 1.0;
  const double across = p.sa * (cap.pole_inside ? 1.0 : k);
  const double s2 = p.s * p.s;
  const double s4 = s2 * s2;
  // I_n = s^4 normal, (3.2): (1 - c)^2 = s^4/(1 + c)^2.
  const double normal = pi / 3 * (2 + p.c) / ((1 + p.c) * (1 + p.c));
  FrictionIntegrals result;
  const FrictionTriple scaled{2 * along * sum.force_pressure,
                              2 * along * sum.sliding_pressure,
                              2 * across * p.s * sum.spinning_pressure};
  result.area = {4 * along * s2 * sum.force_area,
                 2 * along * s2 * sum.sliding_area,
                 2 * across * s2 * p.s * sum.spinning_area};
  if (!cap.beyond_hemisphere) {
    const double inverse = 1 / normal;
    result.normal = s4 * normal;
    result.pressure = {s4 * scaled.force, s4 * scaled.sliding,
                       s4 * scaled.spinning};
    result.coefficient = {inverse * scaled.force, inverse * scaled.sliding,
                          inverse * scaled.spinning};
    return result;
  }
  // The cap is the hemisphere's double less the opposite cap.
  const double one_minus_cos = 1 + p.c;
  result.normal = pi / 3 * one_minus_cos * one_minus_cos * (2 - p.c);
  constexpr double pi2 = pi * pi;
  result.area.sliding = pi2 * p.q - result.area.sliding;
  result.area.spinning = pi2 * p.sa - result.area.spinning;
  result.pressure = {pi2 / 2 * p.q - s4 * scaled.force,
                     pi2 * p.c * p.q + s4 * scaled.sliding,
                     pi2 * p.c * p.sa + s4 * scaled.spinning};
  const double inverse = 1 / result.normal;
  result.coefficient = {inverse * result.pressure.force,
                        inverse * result.pressure.sliding,
                        inverse * result.pressure.spinning};
  return result;
}

}  // namespace contact::detail
