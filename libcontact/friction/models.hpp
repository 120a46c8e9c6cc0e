#pragma once

#include "libcontact/friction/integrals.hpp"

/// Simpler models of the same joint, to compare with the exact integrals. All
/// have the signature, arguments, limits and NaN rules of
/// friction_integrals() of one point, half-angles from 0 to pi.
namespace contact {

class PressureLaw;

/// Sliding-spinning model (section 3.1 of the paper, the dashed lines of its
/// figures 8 and 9): the points of the sphere keep their places, but their
/// velocity is the velocity of the contact's centre plus a spin about the
/// normal,
///
///     Dv = (cos a - sin a sin t sin f, sin a sin t cos f, 0).
///
/// Inner integrals over f: with Gr(p, b) = int (p - b sin f)/w df,
/// w = sqrt(p^2 - 2 p b sin f + b^2), which is 4 E(b/p) for b < p and
/// 4 (p/b) B(p/b) for b > p (B: the cosine part of K),
///
///     I = int g Gr(cos a, sin a sin t) sin t dt,  J: times cos t,
///     K = int g Gr(sin a sin t, cos a) sin^2 t dt.
///
/// Outer integral by tanh-sinh quadrature, split where sin t = cot a. A call
/// costs about a thousand of the exact ones.
/// Largest relative difference from adaptive quadrature of the definition,
/// itself good to some 1e-12: 1.4e-12 (friction/models_test.cpp).
FrictionIntegrals planar_friction_integrals(double half_angle, SlipAxis axis);

/// Viscous analogue (section 3.1 of the paper): traction -k Dv with the
/// velocity Dv of the sphere's points per unit |Dw| and radius. The area
/// integrals belong to a constant k,
///
///     force = k rho^3 |Dw| I,  moments = k rho^4 |Dw| {J, K};
///
/// the pressure integrals to k = k1 p with the cosine pressure, so that for
/// k = k0 + k1 p, with R_n = rho^2 p0 I_n,
///
///     force = rho |Dw| (k0 rho^2 I[1] + k1 R_n chi), and so on.
///
/// Exactly proportional to cos a (force, sliding) and sin a (spinning). With
/// u = 1 - cos theta0:
///
///     I[1] = pi sin^2(theta0) cos a
///     J[1] = pi (2u - u^2 + u^3/3) cos a
///     K[1] = 2 pi (u^2 - u^3/3) sin a
///     I[p] = I_n cos a
///     J[p] = pi u^2 (1 - u/3 + u^2/12) cos a
///     K[p] = 2 pi u^3 (1/3 - u/12) sin a
///
/// Relative error at most 1e-15 (friction/models_test.cpp, 100 digits).
FrictionIntegrals viscous_friction_integrals(double half_angle, SlipAxis axis);

/// The same with any pressure law. The coefficients belong to k1; with S of
/// PressureLaw::force_ratio() and m = ∬ p sin^2 t dS/R_n:
///
///     chi = cos a,  sigma_Y = (S - m/2) cos a,  sigma_Z = m sin a
///
/// `pressure` and `normal` as in friction_integrals(). Relative error, given
/// the law's own pressure, at most 1e-11 for theta0 <= 120 deg
/// (friction/any_pressure_test.cpp).
FrictionIntegrals viscous_friction_integrals(const PressureLaw& law,
                                             double half_angle, SlipAxis axis);

/// Dry friction made to look viscous: the exact values at a = 0 times cos a
/// for force and sliding, those at a = 90 deg times sin a for spinning. How
/// far that is from the exact integrals: docs/explanation/friction.md.
FrictionIntegrals cosine_friction_integrals(double half_angle, SlipAxis axis);

}  // namespace contact
