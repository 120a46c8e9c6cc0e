#pragma once

#include <Eigen/Core>

namespace contact::detail {

/// A contact of one half-angle in quantities that have a meaning at any
/// clearance eps, positive, 0 or negative. Lengths are over
/// K_1 = (4 rho/E) p_1, p_n being the harmonics of the pressure
/// (docs/explanation/preload.md).
struct SignedContact {
  /// x = eps/K_1: 1/(2 lambda) of a pin, (pi/2)/mu of a ball.
  double inverse;
  /// x + c_0: 0 where the contact closes all round.
  double beyond_closure;
  /// 1 - p_0/p_1, 0 where it closes; S = 2 p_0/p_1 (pin), 3 p_0/p_1 (ball).
  double mean_deficit;
  /// D/K_1 - c_1, D the shift of the centres from where they coincide. NaN if
  /// it has no value.
  double gap_shift;
  /// dD/dK_1 - c_1 at constant clearance. NaN if it has no value.
  double gap_compliance;
};

/// The gap of a contact with the coefficients of its series, over K_1.
struct GapField {
  SignedContact contact;
  double opening;   ///< psi
  double mean_gap;  ///< the gap's harmonic 0 (pin), its Phi_0 (ball)
  Eigen::VectorXd series;
};

}  // namespace contact::detail
