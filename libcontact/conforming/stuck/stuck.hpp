#pragma once

#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/layers.hpp"

/// Contacts that stick all over: docs/explanation/presliding.md.
namespace contact::detail {

/// Stiffness of a stuck contact: the force across the load and the moment of a
/// shift s and a turn w of ball or pin about an axis across the load,
///
///     F = shift s + coupling w,  M = coupling s + turn w
///
/// and of a ball's turn about the load, M = spin w. In units of E rho, E rho^2
/// and E rho^3, of pins per length over rho; E is the effective modulus of the
/// pair's surfaces.
struct StuckStiffness {
  double shift;
  double coupling;
  double turn;          ///< K_held: the centre stays
  double spin;          ///< NaN of pins
  double frictionless;  ///< the shift's without tangential tractions, R/D
  /// K_load: the load stays, F = 0. Alone of these it has a value for a pin in
  /// an infinite hole, whose others are counted against 10 radii.
  double load() const { return turn - coupling * coupling / shift; }
};

/// Half-angles and relative thicknesses of layers for which it is known.
inline constexpr double narrowest_stuck = 0.01;  // rad
inline constexpr double widest_stuck = 3.1;      // rad
inline constexpr double thinnest_stuck = 1e-3;   // radii

/// The rotation is that of the outer body's far end against the mean over the
/// volume of a solid inner body.
///
/// Each is a lower bound. Accuracy (conforming/stuck_test.cpp): 5e-4 on 46
/// contacts of half-angles from 5 to 85 deg; the frictionless() limit to 1e-4
/// of R/D.
/// @param half_angle  theta0, rad
/// @return NaN for half-angles and layers outside the limits above, and for
///         bodies that nothing holds
StuckStiffness stuck_stiffness(JointKind kind, const LayeredPair& pair,
                               double half_angle);

}  // namespace contact::detail
