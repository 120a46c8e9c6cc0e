#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "libcontact/half_angle/law.hpp"

/// Inversion shared by the half-angle laws that know the load at a half-angle
/// but not the reverse. They give F and dF/dtheta0 of
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
  return kind == JointKind::ball ? 3 : 2;
}

/// v^2 (pin) or v^3 (ball).
inline double raised(JointKind kind, double v) {
  return kind == JointKind::ball ? v * v * v : v * v;
}

/// x^power over the load parameter: mu = x^3, lambda = x^2/4.
inline double power_per_load(JointKind kind) {
  return kind == JointKind::ball ? 1 : 4;
}

/// The load parameter at theta0 in (0, limit); infinite where F is 0.
template <class Relation>
double load_at(JointKind kind, const Relation& relation, double half_angle) {
  const double sine = std::sin(half_angle / 2);
  const double f = relation(half_angle, sine, std::cos(half_angle / 2)).value;
  return f > 0 ? raised(kind, 2 * sine) / (power_per_load(kind) * f)
               : std::numeric_limits<double>::infinity();
}

/// A guess of theta0 at x, by cubic Hermite interpolation of
///
///     h(s) = theta0/(limit s),   s = xi/(1 + xi),   xi = x/limit,
///
/// which is 1 where theta0 = x (s = 0) and where theta0 = limit (s = 1), and
/// smooth between. Within 1e-8 for usual pairs, so that one point of the
/// relation corrects it to rounding. Always between the half-angles of the
/// nodes on either side: theta0 grows with the load, but of thin free rings by
/// so much between two nodes that the cubic leaves (0, limit).
class HalfAngleStart {
 public:
  /// @param limit  the half-angle at which the load is infinite, or where the
  ///               relation ends before
  /// @param intervals  128 for bodies without walls
  template <class Relation>
  HalfAngleStart(JointKind kind, const Relation& relation, double limit,
                 int intervals = 128);

  double operator()(double x) const {
    const double xi = x * over_limit_;
    const double s = xi / (1 + xi);
    const double place = s * per_s_;
    // (A load beyond the end of the relation: the last interval goes on.)
    const int i =
        std::min(static_cast<int>(place), static_cast<int>(nodes_.size()) - 2);
    const double t = place - i;
    const Node& a = nodes_[i];
    const Node& b = nodes_[i + 1];
    const double rise = b.value - a.value;
    const double first = a.slope - rise;
    const double second = rise - b.slope;
    const double h =
        a.value + t * (rise + (1 - t) * ((1 - t) * first + t * second));
    const double from = i / per_s_ * a.value;
    const double to = (i + 1) / per_s_ * b.value;
    return std::min(limit_ * std::max(from, std::min(s * h, to)), limit_);
  }

 private:
  struct Node {
    double value;  // h
    double slope;  // dh/ds times the width of an interval
  };

  double limit_;
  double over_limit_;
  double per_s_;  // intervals over the range of s
  std::vector<Node> nodes_;
};

/// theta0 at a load in (0, infinity): Newton's method, finished by the cubic
/// through the last two points of the inverse function; a step that leaves the
/// bracket is replaced by halving it. To rounding of the relation; log_slope
/// within 1e-8 of the relation's.
/// @param start  x -> a guess of theta0
/// @param limit  a half-angle above the root
template <class Relation, class Start>
HalfAngleResult solve_half_angle(JointKind kind, const Relation& relation,
                                 const Start& start, double limit,
                                 double load_parameter) {
  const double x = LoadScale::x_from_load_parameter(kind, load_parameter);
  const double over_x = 1 / x;
  const int power = load_power(kind);
  double low = 0;
  double high = limit;
  double theta = start(x);
  // R of a pin is even in theta0: from below 0 it would lead to the mirror
  // root.
  if (!(theta > 0 && theta <= limit)) theta = limit / 2;
  // The point before: residual R, 1/R', F', Newton's step.
  double last_theta = 0, last_residual = 0, last_inverse = 0, last_slope = 0;
  double last_step = 0;
  // One or two points; 60 halvings would do.
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
    // Newton's step is wrong by its square over the distance to where theta(R)
    // is not smooth: theta0 = 0, and the limit where F has a multiple zero.
    // With a point before, Hermite's cubic through both is wrong by the square
    // of the product of their errors. (4e-8)^2 is rounding.
    const double scale = std::max(std::min(theta, limit - theta), 1e-3 * theta);
    const double most = step == 0
                            ? 1e-8 * scale
                            : std::min(0.01 * scale, 4e-8 * scale * scale /
                                                         std::abs(last_step));
    if (std::abs(newton) <= most) {
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

template <class Relation>
HalfAngleStart::HalfAngleStart(JointKind kind, const Relation& relation,
                               double limit, int intervals)
    : limit_(limit), over_limit_(1 / limit), nodes_(intervals + 1) {
  const int power = load_power(kind);
  const double last_load = load_at(kind, relation, limit);
  const double last_xi =
      LoadScale::x_from_load_parameter(kind, last_load) / limit;
  const double range = std::isinf(last_xi) ? 1 : last_xi / (1 + last_xi);
  per_s_ = intervals / range;
  nodes_[0] = {1, 1 / per_s_};
  nodes_[intervals] = {1, -1 / per_s_};
  for (int i = 1; i <= intervals; ++i) {
    const double s = i / per_s_;
    const double rest = 1 - s;
    if (i == intervals && range == 1) break;
    const double x = limit * s / rest;
    // From the node before, along its tangent.
    const Node& before = nodes_[i - 1];
    const double guess = limit * s * (before.value + before.slope);
    const HalfAngleResult there = solve_half_angle(
        kind, relation,
        [&](double) { return std::min(guess, limit * (1 - rest / 100)); },
        limit, raised(kind, x) / power_per_load(kind));
    const double h = there.half_angle / (limit * s);
    // d ln(theta0)/d ln(x) is power log_slope, d ln(x)/ds is 1/(s (1 - s)).
    nodes_[i] = {h, h * (power * there.log_slope / rest - 1) / s / per_s_};
  }
}

}  // namespace contact::detail
