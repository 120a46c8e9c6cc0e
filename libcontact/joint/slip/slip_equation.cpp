#include "libcontact/joint/slip/slip_equation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "libcontact/base/root_finding.hpp"

namespace contact::detail {
namespace {

// f/cos a tends to a constant as cos a -> 0: below this cosine it is taken
// here, where the integrals are still far from underflow.
constexpr double smallest_cosine = 1e-150;

// Keeps tan^2 psi finite. Roots beyond it, of reactions far below 1e-100 N,
// are taken here: g differs from b by some 1e-150.
constexpr double largest_tangent = 1e150;

double positive_cosine(const SlipTriangle<double>& triangle) {
  return std::max(triangle.axis_cos, smallest_cosine);
}

// A residual that is no rounding: the function jumps there.
constexpr double largest_jump = 1e-3;

// ln(a/b) for a close to b.
double log_move(double a, double b) { return 2 * (a - b) / (a + b); }

// ln(a/b), by its series where a is close to b: sooner there than a
// logarithm, and without loss of digits.
double log_ratio(double a, double b) {
  constexpr double small = 1e-4;  // leaves small^4/5 of it
  const double x = (a - b) / (a + b);
  if (!(std::abs(x) < small)) return std::log(a / b);
  return 2 * x * (1 + x * x * (1.0 / 3));
}

// exp(x), by its series for small x.
double exponential(double x) {
  constexpr double small = 1e-3;  // leaves small^5/120
  if (!(std::abs(x) < small)) return std::exp(x);
  const double square = x * x;
  return (1 + x) + square * ((1.0 / 2 + x * (1.0 / 6)) + square * (1.0 / 24));
}

// How the root answers to R and b, from the two slopes of ln(f/cos a) and
//
//   dln R_n     = dln R - sin b cos b sin^2 psi/cos^2 g db
//                 - sin^2 psi cos^2 a dln tan psi
//   dln cos^2 a = 2 cos b/(sin b cos^2 g) db - 2 sin^2 psi sin^2 a dln tan psi
void set_responses(JointSolution::Memory& m, const SlipTriangle<double>& t) {
  const double sin2_psi = t.sin_psi * t.sin_psi;
  const double sin_b = std::max(m.reaction.sin, smallest_cosine);
  m.residual_slope =
      1 + sin2_psi * (m.force_slope * t.axis_cos * t.axis_cos +
                      2 * m.cosine_slope * t.axis_sin * t.axis_sin);
  m.force_response = m.force_slope / m.residual_slope;
  m.angle_response =
      m.reaction.cos / (t.cos_g * t.cos_g * m.residual_slope) *
      (2 * m.cosine_slope / sin_b - m.force_slope * sin_b * sin2_psi);
}

// Moves the memory to a new root. Its slopes change so that they explain
// the change of f/cos a that was seen (Broyden's update).
void learn(JointSolution::Memory& memory, const SlipPoint& point) {
  // Shorter moves are drowned in the rounding of the integrals (4e-15).
  constexpr double smallest_move = 1e-9;
  const double force = log_move(point.normal_force, memory.normal_force);
  const double cosine =
      2 * log_move(positive_cosine(point.triangle), memory.cosine);
  const double square = force * force + cosine * cosine;
  if (square < smallest_move * smallest_move) return;
  const double unexplained = log_move(point.friction, memory.friction) -
                             memory.force_slope * force -
                             memory.cosine_slope * cosine;
  memory.force_slope += unexplained * force / square;
  memory.cosine_slope += unexplained * cosine / square;
}

// Both slopes from differences, where no earlier solution tells them.
void measure_slopes(JointSolution::Memory& memory, const SlipEquation& equation,
                    const SlipPoint& point) {
  // Balances rounding (4e-15/h) against curvature (h).
  constexpr double h = 1e-6;
  const double force = point.normal_force;
  const SlipAxis axis = {point.triangle.axis_sin,
                         positive_cosine(point.triangle)};
  const SlipAxis turned = {
      std::hypot(axis.sin, axis.cos * std::sqrt(h * (2 - h))),
      axis.cos * (1 - h)};
  memory.force_slope =
      std::log(equation.friction(force * (1 + h), axis) / point.friction) /
      std::log1p(h);
  memory.cosine_slope =
      std::log(equation.friction(force, turned) / point.friction) /
      (2 * std::log1p(-h));
}

void remember(JointSolution::Memory& memory, const SlipEquation& equation,
              const SlipPoint& point) {
  memory.valid = std::isfinite(point.friction);
  memory.reaction_force = equation.reaction_force();
  memory.reaction = equation.reaction();
  memory.tangent = point.triangle.tangent;
  memory.normal_force = point.normal_force;
  memory.cosine = positive_cosine(point.triangle);
  memory.friction = point.friction;
  set_responses(memory, point.triangle);
}

// Moves a point on to the root along the straight lines through it and the
// point before: for steps so short that curvature does not count.
void extrapolate(SlipPoint& point, const SlipPoint& before, double share,
                 double step, const SlipEquation& equation) {
  const auto extend = [share](double& value, double old) {
    value += share * (value - old);
  };
  extend(point.half_angle.half_angle, before.half_angle.half_angle);
  extend(point.friction, before.friction);
  extend(point.sliding, before.sliding);
  extend(point.spinning, before.spinning);
  equation.shift_triangle(point, step);
}

struct Start {
  double tangent;
  double slope;  // d residual / d ln tan psi
};

// Secant steps in ln tan psi; not_converged if they do not settle at once.
SlipRoot polish(const SlipEquation& equation, Start start,
                const SolveOptions& options) {
  // From a fair start 2 to 4 steps do; more means that it was not fair.
  constexpr int step_limit = 6;
  // Longer steps leave the neighbourhood that is known.
  constexpr double largest_step = 4;
  SlipRoot root;
  SlipPoint& point = root.point;
  SlipPoint before = equation.at(start.tangent);
  root.evaluations = 1;
  double step = -before.residual / start.slope;
  // The first point has none to extrapolate from: taken as it is.
  root.residual = std::abs(before.residual);
  if (root.residual <= options.tolerance) {
    root.status = Status::ok;
    point = before;
    return root;
  }
  while (std::abs(step) < largest_step) {
    equation.move(point, before.triangle.tangent * exponential(step), before);
    ++root.evaluations;
    const double slope = (point.residual - before.residual) / step;
    const double next = -point.residual / slope;
    // A slope is as good as the distance over which it was seen, so this is
    // about what the step leaves.
    root.residual = std::abs(next) * (std::abs(step) + std::abs(next));
    if (root.residual <= options.tolerance) {
      extrapolate(point, before, next / step, next, equation);
      root.status = Status::ok;
      return root;
    }
    if (std::abs(point.residual) > 0.5 * std::abs(before.residual) ||
        root.evaluations == step_limit) {
      break;
    }
    before = point;
    step = next;
  }
  return root;
}

// The root between bounds: always there, see docs/explanation/joint.md.
SlipRoot bracket(const SlipEquation& equation, double guess,
                 const SolveOptions& options) {
  SlipRoot root;
  root.point = equation.at(largest_tangent);
  root.evaluations = 1;
  if (root.point.residual < 0) {
    root.status = Status::ok;
    return root;
  }
  // Half-angle laws may have no value at large R_n, where g is small: the
  // root can only be at larger g.
  const auto residual = [&](double tangent) {
    const double r = equation.at(tangent).residual;
    return std::isnan(r) ? -1.0 : r;
  };
  constexpr double factor = 4;  // growth of the bounds in their search
  std::uintmax_t evaluations = options.evaluation_limit;
  const auto [low, high] = boost::math::tools::bracket_and_solve_root(
      residual, guess, factor, true,
      boost::math::tools::eps_tolerance<double>(53), evaluations, NoThrow());
  root.point = equation.at(low + (high - low) / 2);
  root.evaluations += static_cast<int>(evaluations) + 1;
  root.residual = std::abs(root.point.residual);
  // Adhesion falls like the root of R_n - R_n0 where interference lifts off, so
  // steeply that the last bit of R_n is more than the tolerance: a bracket of
  // two neighbours has the root, unless more than usual was asked for.
  const bool is_closed =
      evaluations < static_cast<std::uintmax_t>(options.evaluation_limit) &&
      root.residual < largest_jump &&
      options.tolerance >= SolveOptions().tolerance;
  if (root.residual <= options.tolerance || is_closed) {
    root.status = Status::ok;
  } else if (!(root.residual < largest_jump)) {
    // The half-angle law begins to have values here: this is no root.
    root.status = Status::out_of_range;
  }
  return root;
}

}  // namespace

void SlipEquation::set_triangle(SlipPoint& point, double tangent) const {
  point.triangle.set(std::min(tangent, largest_tangent), reaction_.sin,
                     reaction_.cos);
  point.normal_force = reaction_force_ * point.triangle.cos_g;
}

void SlipEquation::shift_triangle(SlipPoint& point, double step) const {
  constexpr double small = 1e-8;  // leaves small^2
  if (!(std::abs(step) < small)) {
    return set_triangle(point, point.triangle.tangent * (1 + step));
  }
  point.normal_force *= 1 - point.triangle.response().force * step;
  point.triangle.shift(step);
}

void SlipEquation::set_friction(SlipPoint& p) const {
  const SlipAxis axis = {p.triangle.axis_sin, positive_cosine(p.triangle)};
  const FrictionIntegrals i = contact_.integrals(p.half_angle.half_angle, axis,
                                                 {p.normal_force, speed_});
  const double pressure = strength_.pressure_part;
  const double area = strength_.area_part / p.normal_force;
  p.friction =
      (pressure * i.coefficient.force + area * i.area.force) / axis.cos;
  p.sliding = pressure * i.coefficient.sliding + area * i.area.sliding;
  p.spinning = pressure * i.coefficient.spinning + area * i.area.spinning;
  p.residual = log_ratio(p.triangle.tangent, p.friction);
}

SlipPoint SlipEquation::at(double tangent) const {
  SlipPoint p;
  set_triangle(p, tangent);
  p.half_angle = contact_.half_angle(p.normal_force);
  set_friction(p);
  return p;
}

void SlipEquation::move(SlipPoint& p, double tangent,
                        const SlipPoint& near) const {
  // Leaves 1e-13/8 of theta0: its second logarithmic derivative is 1/4 at
  // most.
  constexpr double largest_move = 3e-7;
  set_triangle(p, tangent);
  const double move = p.normal_force / near.normal_force - 1;
  if (std::abs(move) < largest_move && !std::isnan(near.half_angle.log_slope)) {
    p.half_angle = near.half_angle;
    p.half_angle.half_angle *= 1 + near.half_angle.log_slope * move;
  } else {
    p.half_angle = contact_.half_angle(p.normal_force);
  }
  set_friction(p);
}

double SlipEquation::friction(double normal_force, SlipAxis axis) const {
  SlipPoint p;
  p.triangle.axis_sin = axis.sin;
  p.triangle.axis_cos = axis.cos;
  p.normal_force = normal_force;
  p.half_angle = contact_.half_angle(normal_force);
  set_friction(p);
  return p.friction;
}

SlipRoot solve_slip(const SlipEquation& equation,
                    const JointSolution::Memory& last,
                    const SolveOptions& options) {
  // Beyond this the last solution is no better than a cold start.
  constexpr double largest_move = 0.3;
  int evaluations = 0;
  if (last.valid) {
    const SineCosine b = equation.reaction();
    const double move =
        last.force_response *
            log_move(equation.reaction_force(), last.reaction_force) +
        last.angle_response *
            (b.sin * last.reaction.cos - b.cos * last.reaction.sin);
    if (std::abs(move) < largest_move) {
      SlipRoot root = polish(
          equation, {last.tangent * exponential(move), last.residual_slope},
          options);
      if (root.status == Status::ok) {
        root.memory = last;
        learn(root.memory, root.point);
        remember(root.memory, equation, root.point);
        return root;
      }
      evaluations += root.evaluations;
    }
  }
  // The paper's first step: g = 0 (4.3).
  SlipRoot root;
  root.point = equation.at(0);
  root.status = Status::ok;
  root.evaluations = ++evaluations;
  const double friction = root.point.friction;
  if (friction == 0) return root;
  const double guess = std::isfinite(friction) ? friction : 1;
  root = polish(equation, {guess, 1}, options);
  evaluations += root.evaluations;
  if (root.status != Status::ok) {
    root = bracket(equation, guess, options);
    evaluations += root.evaluations;
  }
  measure_slopes(root.memory, equation, root.point);
  remember(root.memory, equation, root.point);
  root.evaluations = evaluations + 2;
  return root;
}

}  // namespace contact::detail
