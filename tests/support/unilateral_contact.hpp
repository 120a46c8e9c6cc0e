#pragma once

#include <Eigen/Dense>

#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/material.hpp"

namespace contact::test {

/// Frictionless contact of a pin or a ball on its whole circumference as a
/// complementarity problem, without an assumption on the half-angle: at every
/// node p >= 0, gap >= 0, p gap = 0. Pressure and displacement are expanded in
/// all harmonics resolved by the nodes (cosines; Legendre polynomials). The
/// compliances of disc, hole, ball and cavity are written out separately.
/// Shares nothing with libcontact/conforming except the elastic constants.
struct UnilateralContact {
  Eigen::VectorXd theta;     ///< nodes, rad, increasing, within (0, pi)
  Eigen::VectorXd pressure;  ///< in units of P/rho or R_n/rho^2
  Eigen::VectorXd gap;       ///< in units of the radial clearance
  /// Point at which p^2, nearly linear at the edge, extrapolates to 0 from the
  /// last two nodes in contact, rad.
  double half_angle;
  int iterations;
  bool converged;
};

/// @param load_parameter    lambda or mu
/// @param nodes             number of nodes and of harmonics
/// @param patch_half_angle  psi of loading through the back, rad; negative
///                          for a force at the centre
UnilateralContact solve_unilateral(JointKind kind, const ElasticPair& pair,
                                   double load_parameter, int nodes,
                                   double patch_half_angle = -1);

}  // namespace contact::test
