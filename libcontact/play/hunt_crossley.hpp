// SPDX-License-Identifier: MIT
#pragma once

namespace contact {

/// Damping of an impact, F (1 + a d delta/dt) with any force law F(delta), and
/// its restitution, exact for every law and mass as long as no other force
/// acts: docs/how-to/play.md. With X = a v0, v0 the speed at touch,
///
///     ln((1 + X)/(1 - e X)) = (1 + e) X,   e = (1 + W_0(-(1+X) exp(-1-X)))/X.
///
/// A constant a is a constant of the materials, with a restitution that falls
/// with the speed. For one and the same restitution at every impact make one
/// for each, with the speed of its touch for the reference. What is measured
/// of metals is mostly plastic flow, and a then stands for it.
///
/// Accuracy (play/hunt_crossley_test.cpp): damping and restitution within
/// 1e-12.
class HuntCrossley {
 public:
  /// No damping: restitution 1.
  HuntCrossley() = default;
  /// @param damping  a, s/m, [0, infinity)
  /// @throws Error if it is out of range.
  explicit HuntCrossley(double damping);
  /// @param restitution      e, (0, 1]
  /// @param reference_speed  at which it is e, m/s, > 0
  /// @throws Error if one is out of range.
  static HuntCrossley from_restitution(double restitution,
                                       double reference_speed);

  /// a, s/m
  double damping() const { return damping_; }
  /// e of an impact.
  /// @param speed  v0, m/s, >= 0
  double restitution(double speed) const noexcept;
  /// Strain energy at the turn over the kinetic energy at touch.
  double energy_share(double speed) const noexcept;
  /// Speed of a mass with a strain energy below that at the turn: inwards
  /// (compression) and outwards (restitution), m/s, > 0.
  /// @param energy_per_mass  strain energy to the turn over the mass, J/kg
  double speed_inwards(double energy_per_mass) const noexcept;
  double speed_outwards(double energy_per_mass) const noexcept;

 private:
  double damping_ = 0;
};

/// Damping factors of others, by which restitution is got that was asked for.
struct ApproximateRestitution {
  double lankarani_nikravesh;  ///< X = 3 (1 - e^2)/4, 1990
  double hunt_crossley;        ///< X = 3 (1 - e)/2, 1975
  double flores;               ///< X = 8 (1 - e)/(5 e), 2011
};
/// @param restitution  that is asked for, (0, 1]
ApproximateRestitution approximate_restitution(double restitution) noexcept;

}  // namespace contact
