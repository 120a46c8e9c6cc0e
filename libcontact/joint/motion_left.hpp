#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>

#include "libcontact/base/linear/solve.hpp"
#include "libcontact/joint/moment_set.hpp"

namespace contact::detail {

/// MomentSet::prox() of any set of friction moments, where it does not hold
/// W free: Newton's method on the convex function with halved steps, 3 to 6.
///
/// Along a unit vector u the best length is r(u) = gain(u)/(u . W u), where
/// gain = u . W free - Phi(u), and the function falls to -gain r/2.
///
/// @param moment     -dPhi/du, so that Phi(u) = -u . moment(u)
/// @param curvature  the second derivative of Phi at a unit vector with its
///                   moment
/// @param u          where gain(u) > 0 unless W free lies on the set's edge, as
///                   where the edge opposes W free
template <class Moment, class Curvature>
MomentSet::Prox motion_left(const Moment& moment, const Curvature& curvature,
                            const Eigen::Matrix3d& inertia,
                            const Eigen::Vector3d& free, Eigen::Vector3d u) {
  using Eigen::Matrix3d;
  using Eigen::Vector3d;
  const Vector3d wanted = inertia * free;
  const double size = wanted.norm();
  const auto gain_along = [&](const Vector3d& v, const Vector3d& m) {
    return v.dot(wanted) + v.dot(m);
  };
  const auto value = [&](const Vector3d& v, double gain) {
    return gain > 0 ? -gain * gain / (2 * v.dot(inertia * v)) : 0.0;
  };
  Vector3d edge = moment(u);
  double gain = gain_along(u, edge);
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  // On the edge, up to the rounding of its two parts: no motion.
  const double rounding = 4 * epsilon * size;
  if (gain <= rounding) return {Vector3d::Zero(), -wanted, Status::ok, 0, 0};
  double best = value(u, gain);

  constexpr int step_limit = 60;
  constexpr double tolerance = 1e-13;
  double reachable = 0;
  MomentSet::Prox result{};
  for (result.iterations = 0;; ++result.iterations) {
    const Vector3d inert = inertia * u;
    const double r = gain / u.dot(inert);
    result.angular_velocity = r * u;
    result.moment = edge;
    const Vector3d gradient =
        inertia * (result.angular_velocity - free) - result.moment;
    result.residual = gradient.norm() / size;
    if (result.residual <= tolerance || result.iterations == step_limit) break;
    const Matrix3d slope = curvature(u, edge);
    // Rounding of u moves the moment by its curvature, which small contacts
    // have to 1e6 of W free near the pole; rounding of the gain moves r; and W
    // free - W r u has the rounding of its terms.
    reachable = (epsilon * (2 * slope.norm() + inertia.norm() * free.norm()) +
                 rounding * inert.norm() / u.dot(inert)) /
                size;
    if (result.residual <= reachable) break;
    const Matrix3d second = inertia + slope / r;
    const Vector3d step = -solve_positive(second, gradient);
    // Changes of the function below this are rounding.
    const double unseen = -2 * best * rounding / gain;
    bool moved = false;
    for (double share = 1; share > 1e-10 && !moved; share /= 2) {
      const Vector3d next =
          (result.angular_velocity + share * step).normalized();
      const Vector3d next_edge = moment(next);
      const double next_gain = gain_along(next, next_edge);
      const double next_value = value(next, next_gain);
      if (next_gain > 0 && next_value <= best + unseen) {
        u = next;
        edge = next_edge;
        gain = next_gain;
        best = next_value;
        moved = true;
      }
    }
    if (!moved) break;
  }
  // Moments have roundings of their own, of some 1e-13.
  const bool is_ok = result.residual <= std::max(reachable, 1e-12);
  result.status = is_ok ? Status::ok : Status::not_converged;
  return result;
}

}  // namespace contact::detail
