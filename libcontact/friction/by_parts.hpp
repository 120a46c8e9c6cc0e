#pragma once

#include "libcontact/friction/integrals.hpp"
#include "libcontact/friction/kernel/cap_kernel.hpp"
#include "libcontact/pressure/law.hpp"

namespace contact::detail {

/// Friction coefficients with any pressure by its edge_slopes() alone: p is a
/// sum of uniform pressures over smaller contacts, whose integrals are the area
/// integrals of the exact method,
///
///     ∬ p ... dS = ∫ (dp/dx) area(theta0(x)) dx,  0 <= x <= 1.
///
/// Relative error, given the slopes, at most 1e-10 for theta0 <= 120 deg
/// (friction/own_pressure_test.cpp). 56 area integrals, 128 with walls, twice
/// as many with a pole in the contact; allocates when it is called for the
/// first time.
/// @param half_angle  theta0, rad, (0, largest_half_angle()]
FrictionTriple coefficients_by_parts(const PressureLaw& law, double half_angle,
                                     SlipAxis axis, const CapKernel& kernel);

}  // namespace contact::detail
