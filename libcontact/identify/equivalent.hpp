// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "libcontact/joint/joint.hpp"
#include "libcontact/joint/spec.hpp"

/// Numbers for the friction formulas of other programs
/// (docs/how-to/equivalent.md).
namespace contact {

/// A number to type into another program.
struct LeastWrong {
  double value;
  /// Largest relative error of the friction moment that the program then has,
  /// over the states that were given: no other number has a smaller one.
  double largest_error;
};

/// Numbers with which the formulas of other programs come nearest to a joint.
///
/// A formula gives the moment that resists the turning, M = -M_t . Dw/|Dw|.
/// Where a program resists about each axis of its own, a ball that turns about
/// none of them is resisted up to sqrt(3) times as much as about one: errors
/// are those over all directions of these axes.
struct EquivalentFriction {
  LeastWrong arm;  ///< c of M = c R, m
  /// c of M = M0 + c R, m; c and M0 are not below 0.
  LeastWrong arm_with_preload;
  double preload;              ///< M0 beside it, N m
  LeastWrong arm_per_axis;     ///< c of M = c R about each axis, m
  LeastWrong moment;           ///< M0 of M = M0, N m
  LeastWrong moment_per_axis;  ///< M0 of M = M0 about each axis, N m
};

/// Finds these numbers for some states of a joint: the error is over these, so
/// that they have to be as dense as it is to be sure.
/// @param states  at least one; |Dw| above 0
/// @return errors to 1e-13, those with a preload to 1e-9
///         (identify/equivalent_test.cpp)
/// @throws Error for no states, and a state without friction or solution
EquivalentFriction equivalent_friction(const Joint& joint,
                                       std::span<const Joint::Slip> states);

/// Finds the deformation before sliding, m, that comes nearest to
/// stiction_deformation() over some states of a joint: what Adams
/// asks for; over rho the angle z_ss of LuGre, Dahl and MuJoCo's dcmotor. A
/// stiffness follows from it with the load, sigma0 = M_s(R)/z_ss.
/// @return the error over the states to 1e-13 (identify/equivalent_test.cpp);
///         the error of the formula comes on top. NaN where a state has none.
/// @throws Error for no states
LeastWrong equivalent_stiction(const Joint& joint,
                               std::span<const Joint::Slip> states);

/// Finds R_b of M = c R (1 + z/R_b), m: the bending arm of a pin whose load R
/// stands off the middle by z, the bending moment over R.
/// @param pin     with dry friction; laws are taken as exact
/// @param forces  R, N, above 0
/// @param reach   z runs from 0 to it in 16 steps, m; above 0
/// @param arm     c, m, of equivalent_friction()
/// @return infinite where bending adds nothing; the error to 1e-7
///         (identify/equivalent_test.cpp)
/// @throws Error as FinitePin, and for a load without solution
LeastWrong equivalent_bending_arm(const JointSpec& pin,
                                  std::span<const double> forces, double reach,
                                  double arm);

}  // namespace contact
