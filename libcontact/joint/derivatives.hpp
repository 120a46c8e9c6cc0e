// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "libcontact/joint/joint.hpp"

namespace contact {

/// Derivatives of the friction moment of a sliding joint by its causes, for
/// implicit integrators and Newton's method. Rows are parts of M_t.
struct SlipDerivatives {
  /// out_of_range, and all NaN, where there are none: at rest, at a rim of a
  /// seat, of an interference without load, of a solution that is not ok.
  Status status = Status::out_of_range;
  /// dM_t/dDw at fixed n, R_n and theta0, N m s. If friction does not depend
  /// on the speed, it is symmetric, and Dw is in its kernel: the curvature of
  /// the power that MomentSet has.
  Eigen::Matrix3d at_contact = Eigen::Matrix3d::Zero();
  /// dM_t/dDw at fixed R, N m s: n, R_n and theta0 follow.
  Eigen::Matrix3d over_rate = Eigen::Matrix3d::Zero();
  /// dM_t/dR at fixed Dw, m.
  Eigen::Matrix3d over_reaction = Eigen::Matrix3d::Zero();
};

/// The derivatives of Joint::solve(). docs/internals/joint_solver.md has the
/// formulas: closed ones in the vectors and in n, R_n of the solution; what the
/// contact's friction has over R_n, a and |Dw| is differences of fourth order.
///
/// A pin's Dw stays along its axis, and R normal to it.
///
/// @param solution  Joint::solve() of the slip
/// @return of smooth laws to 6e-7 of the largest element against differences of
///         solve(): 5e-7 where the slip axis pierces the contact's edge, of
///         2000 random slips 1e-8 in the mean (joint/derivatives_test.cpp).
///         Beside the kinks of a friction table whose curve is linear, 1e-3.
///         Neither allocates nor throws.
SlipDerivatives derivatives(const Joint& joint, const Joint::Slip& slip,
                            const JointSolution& solution) noexcept;

}  // namespace contact
