#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "libcontact/half_angle.hpp"

/// What the half-angle laws share that know the load at a half-angle and not
/// the other way round. They give F and dF/dtheta0 of
///
///     F(theta0) = (2 sin(theta0/2)/x)^power,   power = 2 (pin), 3 (ball),
///
/// which falls from 1 at theta0 = 0 to 0 at the limit half-angle; x is the
/// variable of the half-angle laws. A Relation is a callable
/// (theta0, sin(theta0/2), cos(theta0/2)) -> RelationValue.
namespace contact::detail {

struct RelationValue {
  double value;  ///< F
  double slope;  ///< dF/dtheta0
};

inline int load_power(JointKind kind) {
  return kind == JointKind::spherical ? 3 : 2;
}

/// v^2 (pin) or v^3 (ball).
inline double raised(JointKind kind, double v) {
  return kind == JointKind::spherical ? v * v * v : v * v;
}

/// x^power over the load parameter: mu = x^3, lambda = x^2/4.
inline double power_per_load(JointKind kind) {
  return kind == JointKind::spherical ? 1 : 4;
}

/// The load parameter at theta0 in (0, limit); infinite where F is 0.
template <class Relation>
double load_at(JointKind kind, const Relation& relation, double half_angle) {
  const double sine = std::sin(half_angle / 2);
  const double f = relation(half_angle, sine, std::cos(half_angle / 2)).value;
  return f > 0 ? raised(kind, 2 * sine) / (power_per_load(kind) * f)
               : std::numeric_limits<double>::infinity();
}

/// A first guess of theta0 at x, within 0.4 % for usual pairs: the direct law
///
///     theta0 = limit xi sqrt((1 + n1 xi + n2 xi^2)
///              / (1 + d1 xi + d2 xi^2 + n1 xi^3 + n2 xi^4)),  xi = x/limit
///
/// (that of NominalLaw) through four points of the relation.
class DirectStart {
 public:
  template <class Relation>
  DirectStart(JointKind kind, const Relation& relation, double limit)
      : limit_(limit), over_limit_(1 / limit) {
    std::array<double, 4> xi;
    for (int i = 0; i < 4; ++i) {
      const double load = load_at(kind, relation, shares[i] * limit);
      xi[i] = x_from_load_parameter(kind, load) / limit;
    }
    fit(xi);
  }

  double operator()(double x) const {
    const double xi = x * over_limit_;
    // theta0/x squared for small xi, theta0/limit squared for large ones.
    double ratio;
    if (xi < 1) {
      const double n = xi * (n1_ + xi * n2_);
      ratio = (1 + n) / (1 + xi * (d1_ + xi * (d2_ + n)));
    } else {
      const double y = 1 / xi;
      const double p = n2_ + y * (n1_ + y);
      ratio = p / (p + y * y * (d2_ - 1 + y * (d1_ + y)));
    }
    const double guess = (xi < 1 ? x : limit_) * std::sqrt(ratio);
    return guess > 0 && guess < limit_ ? guess : limit_ * std::tanh(xi);
  }

 private:
  // theta0/limit of the points.
  static constexpr std::array<double, 4> shares = {0.2, 0.55, 0.85, 0.97};
  void fit(const std::array<double, 4>& xi);

  double limit_;
  double over_limit_;
  double n1_, n2_, d1_, d2_;
};

/// theta0 at a load in (0, infinity): Newton's method, finished by the cubic
/// through the last two points of the inverse function; a step that leaves the
/// bracket is replaced by halving it. To rounding of the relation; log_slope
/// within 1e-8 of the relation's.
/// @param limit  a half-angle above the root
template <class Relation>
HalfAngleResult solve_half_angle(JointKind kind, const Relation& relation,
                                 const DirectStart& start, double limit,
                                 double load_parameter) {
  const double x = x_from_load_parameter(kind, load_parameter);
  const double over_x = 1 / x;
  const int power = load_power(kind);
  double low = 0;
  double high = limit;
  double theta = start(x);
  // The point before: residual R, 1/R', F', Newton's step.
  double last_theta = 0, last_residual = 0, last_inverse = 0, last_slope = 0;
  double last_step = theta;
  // Two or three points; 60 halvings would do.
  constexpr int step_limit = 60;
  for (int step = 0; step < step_limit; ++step) {
    const double sine = std::sin(theta / 2);
    const double cosine = std::cos(theta / 2);
    const RelationValue f = relation(theta, sine, cosine);
    // R = F - (2 sin(theta0/2)/x)^power, which falls.
    const double load_term = raised(kind, 2 * sine * over_x);
    const double residual = f.value - load_term;
    // The slope of load_term is itself power cos(theta0/2)/(2 sin(theta0/2)).
    const double inverse =
        2 * sine / (2 * sine * f.slope - load_term * power * cosine);
    (residual > 0 ? low : high) = theta;
    const double newton = -residual * inverse;
    // Hermite's cubic through two points of theta(R) is wrong by the square
    // of the product of their errors, over the distance to where theta(R) is
    // not smooth: theta0 = 0, and the limit where F has a multiple zero.
    // (4e-8)^2 is rounding.
    const double scale = std::max(std::min(theta, limit - theta), 1e-3 * theta);
    if (std::abs(newton * last_step) <= 4e-8 * scale * scale &&
        std::abs(newton) < 0.01 * scale) {
      double change = newton;
      double slope = f.slope;
      if (step > 0) {
        const double h = 1 / (residual - last_residual);
        const double secant = (theta - last_theta) * h;
        const double second = (inverse - secant) * h;
        const double third = (second - (secant - last_inverse) * h) * h;
        const double correction =
            residual * residual * (second - third * last_residual);
        // (Both residuals may be rounding, next to the limit.)
        if (std::abs(correction) < std::abs(newton)) {
          change += correction;
          slope += (f.slope - last_slope) / (theta - last_theta) * change;
        }
      }
      // At the root, to second order: sin(theta0/2), cos(theta0/2) and F.
      const double root = std::min(theta + change, limit);
      const double sine_there = sine + change / 2 * cosine;
      const double cosine_there = cosine - change / 2 * sine;
      const double value = raised(kind, 2 * sine_there * over_x);
      const double log_slope =
          2 * sine_there * value /
          (root * (power * cosine_there * value - 2 * sine_there * slope));
      return {root, Status::ok, std::max(0.0, log_slope)};
    }
    last_theta = theta;
    last_residual = residual;
    last_inverse = inverse;
    last_slope = f.slope;
    last_step = newton;
    const double next = theta + newton;
    theta = next > low && next < high ? next : low + (high - low) / 2;
  }
  // Near a multiple zero of F, R is rounding over a stretch of theta0, which
  // hardly depends on the load any more.
  if (std::abs(last_residual) <= 1e-13) return {theta, Status::ok, 0};
  return {theta, Status::not_converged};
}

}  // namespace contact::detail
