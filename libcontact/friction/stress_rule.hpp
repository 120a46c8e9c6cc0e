#pragma once

#include "libcontact/friction/integrals.hpp"
#include "libcontact/pair/friction_stress.hpp"
#include "libcontact/pressure/law.hpp"

namespace contact {

/// A friction stress over a contact that slides.
struct StressedContact {
  double half_angle;     ///< theta0, rad
  double pressure_unit;  ///< JointGeometry::pressure_unit(), Pa
  double rim_speed;      ///< rho |Dw|, m/s
  /// Pressure of a contact closed all round in addition to the law's, Pa:
  /// JointContact::uniform_pressure().
  double uniform_pressure = 0;
};

/// Points of stress_integrals(): n - 2 great circles of n + 2 points, or twice
/// that where they cross the slip axis, up to six times where the stress
/// changes fast beside it (FrictionStress::speed_scale()).
inline constexpr int usual_stress_points = 24;

/// Friction force over rho^2 and moments over rho^3 of a ball's contact, Pa:
///
///     ∬ tau e dO,  e = v/|v|;  about Y and Z ∬ tau (-e x r) dO
///
/// Up to 90 deg along great circles through the slip axis, beyond by the
/// definition with double exponential nodes (docs/how-to/friction_stress.md).
/// @param points  n, 4 or more
/// @return relative error at most 1e-10 for tau that is smooth in p and v and
///         for powers of p, 1e-9 for functions of v/p, which change fast
///         towards the edge; 1e-10 beyond 90 deg
///         (joint/friction_stress_test.cpp). 1e-6 for tables, and 7e-8 for
///         Stribeck's curve below 0.1 rim speeds if the slip axis passes the
///         edge closely outside. NaN where the law has no value
///         and at theta0 = 0.
/// Does not throw; with the usual number of points nothing allocates but in
/// the first call.
FrictionTriple stress_integrals(const PressureLaw& law,
                                const StressedContact& contact, SlipAxis axis,
                                const FrictionStress& stress,
                                int points = usual_stress_points);

/// The same of a pin: force over rho l, sliding moment over rho^2 l, Pa.
FrictionTriple pin_stress_integrals(const PressureLaw& law,
                                    const StressedContact& contact,
                                    const FrictionStress& stress,
                                    int points = usual_stress_points);

}  // namespace contact
