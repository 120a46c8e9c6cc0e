#pragma once

#include "programs/joint/input.hpp"
#include "programs/joint/setup.hpp"

namespace hinge_joint {

/// Above friction coefficients of engineering surfaces. Up to it |M_t| under a
/// given reaction grows with f0; beyond, the moment of a pin reaches its
/// largest value, a few % above rho R, and falls.
inline constexpr double largest_measured_friction = 3;

/// Gives each joint the friction coefficient with which its |M_t| is a measured
/// one, to 1e-13 (tests/programs/measured_moment_test.cpp).
/// @param moment  of --measured-moment, N m
/// @param setup   its friction dry; f0 is not looked at
/// Throws contact::Error if there is not one state, or none has that moment.
void find_friction(double moment, const Inputs& inputs, Setup& setup);

}  // namespace hinge_joint
