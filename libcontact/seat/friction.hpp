#pragma once

#include <Eigen/Core>

#include "libcontact/seat/windows.hpp"

namespace contact::detail {

/// What the pressures of a contact say of its friction, for one slip axis w:
/// sums over the contact with the direction of slip e = w x r/|w x r|.
struct SeatSlip {
  Eigen::Vector3d force;   ///< f = ∫ e p dS, N
  Eigen::Vector3d moment;  ///< m = ∫ r x e p dS, r a unit vector, N
};

/// Friction of a patch for any slip axis, by two functions of it,
///
///     Phi(w) = ∫ |w x r| p dS,   Xi(w) = ∫ asin(w.r) p dS,
///     m = w Phi + grad Phi,      f = w x grad Xi,
///
/// whose harmonics are those of the pressure times numbers (Funk and Hecke):
/// one set of harmonics serves every axis. Friction forces are -f0 f, moments
/// -rho f0 m.
///
/// Accuracy (seat/friction_test.cpp), over the load: 3e-5 in the median; for
/// axes that pierce the contact beside a rim 3e-3 with 64 degrees, 1e-3 with
/// 130.
class SeatHarmonics {
 public:
  /// @param degrees  n below this, 2 to 400
  SeatHarmonics(const SeatSolution& solution, double unit_force,
                int degrees = 64);

  /// @param axis  w, unit vector in the plane of the load's axes: x on its
  ///              side, z the seat's axis
  SeatSlip operator()(const Eigen::Vector3d& axis) const;

 private:
  int degrees_;
  Eigen::MatrixXd harmonics_;  // (n, m): of Phi for even n, of Xi for odd ones
  Eigen::MatrixXd ratio_;      // of the recursion in n
};

}  // namespace contact::detail
