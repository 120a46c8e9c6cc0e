// SPDX-License-Identifier: MIT
#pragma once

#include "libcontact/joint/contact.hpp"

/// Joints before they slide: docs/explanation/presliding.md.
namespace contact {

/// How far the surfaces move over each other before the joint slides, m: f0 D
/// with D of JointContact::shift(), the way to where the contact has climbed
/// its seat by the friction angle while R stays. Over rho it is the angle.
///
/// Adhesion and the spread of the slip are left out: right to 21 % where metal
/// lies on metal, a lower bound for liners, which take 1.2 to 4 times as much
/// (joint/presliding_test.cpp, against contacts that slip bit by bit).
///
/// @param normal_force  R_n, N, > 0
/// @param half_angle    theta0, rad
/// @return NaN of friction that is not dry, with interference, and without D: a
///         pin in an infinite hole, a half-angle law other than exact
double stiction_deformation(const JointContact& contact, double normal_force,
                            double half_angle) noexcept;

}  // namespace contact
