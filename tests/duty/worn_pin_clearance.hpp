#pragma once

#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <numbers>
#include <span>

#include "libcontact/joint/contact.hpp"

namespace contact::test {

/// A load, and the path in a cycle over which the wearing surface slides under
/// it.
struct LoadedPath {
  double normal_force;  ///< R_n, N
  double path;          ///< m/Pa
};

/// Clearance after cycles in which one surface wears uniformly, m. It stays
/// round: d eps/d path = S P/(2 pi rho) at every clearance, by the joint's own
/// laws. The growth agrees with wear.csv to 1e-6, the rounding of its loads.
inline double clearance_of_worn_pin(const JointContact& contact,
                                    std::span<const LoadedPath> cycle,
                                    double cycles) {
  const JointGeometry& geometry = contact.geometry();
  const double area =
      2 * std::numbers::pi * geometry.radius() * geometry.length();
  const auto rate = [&](double clearance, double& growth, double) {
    const JointContact now = contact.with_clearance(clearance);
    growth = 0;
    for (const auto& [force, path] : cycle) {
      const double half_angle = now.half_angle(force).half_angle;
      growth += path * now.sum_of_pressures(force, half_angle) / area;
    }
  };
  // A thousandth of the half-angle law's errors: S has a kink at lift-off.
  constexpr double tolerance = 1e-10;
  namespace odeint = boost::numeric::odeint;
  using Stepper = odeint::runge_kutta_dopri5<double>;
  double clearance = geometry.radial_clearance();
  odeint::integrate_adaptive(odeint::make_controlled<Stepper>(
                                 tolerance * std::abs(clearance), tolerance),
                             rate, clearance, 0.0, cycles, cycles / 100);
  return clearance;
}

}  // namespace contact::test
