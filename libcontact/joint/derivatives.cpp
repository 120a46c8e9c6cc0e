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

FrictionTriple combined(double a, const FrictionTriple& x, double b,
                        const FrictionTriple& y) {
  return {a * x.force + b * y.force, a * x.sliding + b * y.sliding,
          a * x.spinning + b * y.spinning};
}

// Derivative at 0 of a function of a number, by values at +-h and +-2h.
template <class Function>
FrictionTriple slope(const Function& at, double h) {
  const FrictionTriple near = combined(1, at(h), -1, at(-h));
  const FrictionTriple far = combined(1, at(2 * h), -1, at(-2 * h));
  return combined(8 / (12 * h), near, -1 / (12 * h), far);
}

// Friction force and both moments over rho, N, and their slopes over ln R_n, a
// and ln |Dw|.
struct ContactSlopes {
  FrictionTriple value, over_force, over_axis, over_speed;

  ContactSlopes(const JointContact& contact, const JointSolution& s,
                double speed) {
    const auto at = [&](double force, SlipAxis axis, double rate) {
      return contact.friction_at(contact.half_angle(force).half_angle, axis,
                                 {force, rate});
    };
    const SlipAxis& axis = s.slip_axis;
    const double force = s.normal_force;
    value = contact.friction_at(s.half_angle, axis, {force, speed});
    over_force = slope(
        [&](double x) { return at(force * std::exp(x), axis, speed); }, step);
    // The friction changes over angles of 90 deg - a or theta0, whichever is
    // larger.
    const double scale = std::max(axis.cos, std::min(1.0, s.half_angle));
    over_axis = slope(
        [&](double x) {
          const double sine = axis.sin * std::cos(x) + axis.cos * std::sin(x);
          const double cosine = axis.cos * std::cos(x) - axis.sin * std::sin(x);
          const FrictionTriple t = contact.friction_at(
              s.half_angle, {sine, std::abs(cosine)}, {force, speed});
          // Beyond 90 deg the slip at the centre turns round.
          return cosine < 0 ? FrictionTriple{-t.force, -t.sliding, t.spinning}
                            : t;
        },
        step * scale);
    over_speed = slope(
        [&](double x) {
          return contact.friction_at(s.half_angle, axis,
                                     {force, speed * std::exp(x)});
        },
        step);
  }
};

// R = N + R_t and M_t as functions of N = R_n n and Dw, and their changes.
struct Jacobians {
  Matrix3d reaction_over_normal, reaction_over_rate;
  Matrix3d moment_over_normal, moment_over_rate;
};

// docs/explanation/joint.md, (10) to (13).
Jacobians jacobians(const JointContact& contact, const JointSolution& s,
                    const Vector3d& w, double speed) {
  const ContactSlopes f(contact, s, speed);
  const double side = contact.geometry().side();
  const double rho = contact.geometry().radius();
  const double sin_a = s.slip_axis.sin;
  constexpr double smallest_cosine = 1e-150;
  const double cos_a = std::max(s.slip_axis.cos, smallest_cosine);
  const Vector3d& n = s.normal;
  const Vector3d cross = w.cross(n);
  const Vector3d t =
      cross.isZero(0) ? w.unitOrthogonal() : cross.stableNormalized();
  const Vector3d d = t.cross(w);
  const Vector3d j = n.cross(t);
  const RowVector3d nt = n.transpose(), tt = t.transpose(), dt = d.transpose(),
                    jt = j.transpose(), wt = w.transpose();
  const auto over_cos = [&](double FrictionTriple::*of) {
    const FrictionTriple at = contact.friction_at(s.half_angle, {sin_a, cos_a},
                                                  {s.normal_force, speed});
    return at.*of / cos_a;
  };
  const double force_over_cos = over_cos(&FrictionTriple::force);
  const double sliding_over_cos = over_cos(&FrictionTriple::sliding);

  Jacobians result;
  const double of_normal = 1 / s.normal_force;
  result.reaction_over_normal =
      Matrix3d::Identity() -
      side * of_normal *
          (t * (f.over_force.force * nt + f.over_axis.force * jt) -
           force_over_cos * d * tt);
  result.reaction_over_rate =
      -side / speed *
      (t * (f.over_axis.force * dt + f.over_speed.force * wt) -
       f.value.force * w * tt + force_over_cos * sin_a * d * tt);
  result.moment_over_normal =
      -rho * of_normal *
      (j * (f.over_force.sliding * nt + f.over_axis.sliding * jt) -
       f.value.sliding * n * jt - sliding_over_cos * sin_a * t * tt +
       n * (f.over_force.spinning * nt + f.over_axis.spinning * jt) +
       f.value.spinning * (j * jt + t * tt));
  result.moment_over_rate =
      -rho / speed *
      (j * (f.over_axis.sliding * dt + f.over_speed.sliding * wt) +
       sliding_over_cos * t * tt +
       n * (f.over_axis.spinning * dt + f.over_speed.spinning * wt));
  return result;
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
