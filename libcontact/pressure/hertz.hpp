#pragma once

#include "libcontact/pair/joint_geometry.hpp"

namespace contact {

/// Hertz' own peak pressure, Pa, of a ball of radius rho in a seat or a pin in
/// a hole of radius rho + eps:
///
///     ball:  3 R_n/(2 pi a^2)
///     pin:   2 P/(pi a),        a = rho sin(theta0)
///
/// with the theta0 of HertzLaw at the joint's load parameter times its
/// load_factor(). Hertz takes the contact for flat: the pressure carries the
/// load of its projection. 7 % below the exact peak at 19 deg (steel on
/// bronze).
///
/// Accuracy: relative error at most 1e-15 (pressure/family_test.cpp, against
/// Hertz' formulas in the two radii).
/// @param load        R_n, N, or P, N/m; > 0
/// @param half_angle  theta0 of HertzLaw at that load, rad
double hertz_peak_pressure(const JointGeometry& geometry, double load,
                           double half_angle) noexcept;

/// The same over the nominal pressure of a seat without end: 3/(2 sin^2 theta0)
/// of a ball, 4/(pi sin theta0) of a pin.
double hertz_peak_over_nominal(JointKind kind, double half_angle) noexcept;

}  // namespace contact
