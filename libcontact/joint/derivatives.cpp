#include "libcontact/joint/derivatives.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "libcontact/base/magnitude.hpp"

namespace contact {
namespace {

using Eigen::Matrix3d;
using Eigen::RowVector3d;
using Eigen::Vector3d;

// Balances rounding (4e-15/h) against curvature (h^4).
constexpr double step = 1e-3;

// f, P and A times R_n, N: docs/internals/joint_solver.md, (14). Beyond 90 deg
// the slip at the centre turns round.
Vector3d friction_at(const JointContact& contact, double half_angle,
                     const SlipAxis& axis, double force, double speed) {
  const FrictionTriple of = contact.friction_at(
      half_angle, {axis.sin, std::abs(axis.cos)}, {force, speed});
  const double sliding = axis.cos < 0 ? -of.sliding : of.sliding;
  return {axis.cos < 0 ? -of.force : of.force,
          axis.cos * sliding + axis.sin * of.spinning,
          axis.cos * of.spinning - axis.sin * sliding};
}

// Derivative at 0 of a function of a number, by values at +-h and +-2h.
template <class Function>
Vector3d slope(const Function& at, double h) {
  return (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
}

// These and their slopes over ln R_n, a and ln |Dw|.
struct Slopes {
  Vector3d value, over_load, over_axis, over_speed;
};

Slopes slopes_of(const JointContact& contact, const JointSolution& s,
                 const SlipAxis& a, double speed) {
  const double load = s.normal_force, theta0 = s.half_angle;
  const auto over_load = [&](double x) {
    const double more = load * std::exp(x);
    return friction_at(contact, contact.half_angle(more).half_angle, a, more,
                       speed);
  };
  const auto over_axis = [&](double x) {
    return friction_at(contact, theta0,
                       {a.sin * std::cos(x) + a.cos * std::sin(x),
                        a.cos * std::cos(x) - a.sin * std::sin(x)},
                       load, speed);
  };
  const auto over_speed = [&](double x) {
    return friction_at(contact, theta0, a, load, speed * std::exp(x));
  };
  // The friction changes over angles of 90 deg - a or theta0, whichever is
  // larger.
  const double scale = std::max(a.cos, std::min(1.0, theta0));
  return {over_speed(0), slope(over_load, step), slope(over_axis, step * scale),
          slope(over_speed, step)};
}

// R = N + R_t and M_t as functions of N = R_n n and Dw, and their changes.
struct Jacobians {
  Matrix3d reaction_over_normal, reaction_over_rate;
  Matrix3d moment_over_normal, moment_over_rate;
};

// docs/internals/joint_solver.md, (10) to (14): P over a is by its
// potential.
Jacobians jacobians(const JointContact& contact, const JointSolution& s,
                    const Vector3d& w, double speed) {
  constexpr double smallest_cosine = 1e-150;
  const SlipAxis a = {s.slip_axis.sin,
                      std::max(s.slip_axis.cos, smallest_cosine)};
  const auto [value, over_load, over_axis, over_speed] =
      slopes_of(contact, s, a, speed);
  const double f_over_cos = value[0] / a.cos, A_over_cos = value[2] / a.cos;
  const double side = contact.geometry().side();
  const double rho = contact.geometry().radius();
  const Vector3d cross = w.cross(s.normal);
  const Vector3d t =
      cross.isZero(0) ? w.unitOrthogonal() : cross.stableNormalized();
  const Vector3d d = t.cross(w);
  const RowVector3d nt = s.normal.transpose(), tt = t.transpose(),
                    dt = d.transpose(), wt = w.transpose(),
                    jt = s.normal.cross(t).transpose();
  return {
      Matrix3d::Identity() - side / s.normal_force *
                                 (t * (over_load[0] * nt + over_axis[0] * jt) -
                                  f_over_cos * d * tt),
      -side / speed *
          (t * (over_axis[0] * dt + over_speed[0] * wt) - value[0] * w * tt +
           f_over_cos * a.sin * d * tt),
      -rho / s.normal_force *
          (w * (over_load[1] * nt + (value[2] + over_speed[2]) * jt) +
           d * (over_load[2] * nt + over_axis[2] * jt) + A_over_cos * t * tt),
      -rho / speed *
          (w * (over_speed[2] * dt + over_speed[1] * wt) +
           d * ((over_axis[2] + value[1]) * dt + over_speed[2] * wt) +
           (value[1] - A_over_cos * a.sin) * t * tt)};
}

}  // namespace

SlipDerivatives derivatives(const Joint& joint, const Joint::Slip& slip,
                            const JointSolution& solution) noexcept {
  SlipDerivatives result;
  if (solution.status == Status::ok && solution.state == JointState::unloaded) {
    result.status = Status::ok;
    return result;
  }
  if (solution.status != Status::ok || solution.state != JointState::sliding ||
      solution.normal_force == 0 || std::isnan(solution.half_angle)) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    result.at_contact = result.over_rate = result.over_reaction =
        Matrix3d::Constant(nan);
    return result;
  }
  const double speed = magnitude(slip.angular_velocity);
  const Vector3d w = slip.angular_velocity.stableNormalized();
  Jacobians by = jacobians(joint.contact(), solution, w, speed);
  Matrix3d across = Matrix3d::Identity();
  if (joint.is_pin()) {
    const Matrix3d along = w * w.transpose();
    across -= along;
    by.reaction_over_rate *= along;
    by.moment_over_rate *= along;
  }
  result.status = Status::ok;
  result.at_contact = by.moment_over_rate;
  result.over_reaction =
      by.moment_over_normal * by.reaction_over_normal.inverse() * across;
  result.over_rate =
      by.moment_over_rate - result.over_reaction * by.reaction_over_rate;
  return result;
}

}  // namespace contact
