#pragma once

#include "programs/joint/input.hpp"
#include "programs/joint/setup.hpp"

namespace hinge_joint {

/// Exceeds the friction coefficients of engineering surfaces. Up to here |M_t|
/// under a given reaction grows with f0; beyond, the moment of a pin passes its
/// maximum, a few percent above rho R, and falls.
inline constexpr double largest_measured_friction = 3;

/// Sets each joint's friction coefficient so that |M_t| equals a measured
/// moment, to 1e-13 (tests/programs/measured_moment_test.cpp).
/// @param moment  of --measured-moment, N m
/// @param setup   with dry friction; its f0 is ignored
/// Throws contact::Error unless there is exactly one state, and if no
/// coefficient gives this moment.
void find_friction(double moment, const Inputs& inputs, Setup& setup);

}  // namespace hinge_joint
