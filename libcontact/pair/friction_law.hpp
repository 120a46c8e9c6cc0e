// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

#include "libcontact/pair/friction_stress.hpp"

/// Friction of the contact surface: dry, with a coefficient that depends on
/// the contact pressure, viscous, or any stress of pressure and speed.
namespace contact {

/// f(p) = f0 + A/p, that is the friction stress f p = f0 p + A.
///
/// f0 is the coefficient at high pressure, A the adhesion: the friction stress
/// that is left when the pressure vanishes. Source: the paper, section 3, the
/// paragraph after (3.1).
class FrictionLaw {
 public:
  /// @param coefficient  f0, [0, infinity)
  /// @param adhesion     A, Pa, [0, infinity)
  /// @throws Error if an argument is out of range.
  explicit FrictionLaw(double coefficient, double adhesion = 0);

  /// f0
  double coefficient() const { return coefficient_; }
  /// A, Pa
  double adhesion() const { return adhesion_; }

  /// f(p) = f0 + A/p; infinite at p = 0 with adhesion.
  /// @param pressure  p, Pa, >= 0
  double coefficient_at(double pressure) const {
    return adhesion_ == 0 ? coefficient_ : coefficient_ + adhesion_ / pressure;
  }
  /// Friction stress f0 p + A, Pa.
  /// @param pressure  p, Pa, >= 0
  double stress_at(double pressure) const {
    return coefficient_ * pressure + adhesion_;
  }

  friend bool operator==(const FrictionLaw&, const FrictionLaw&) = default;

 private:
  double coefficient_;
  double adhesion_;
};

/// Lubricated contact: friction stress (k0 + k1 p) v, v = sliding speed.
///
/// It vanishes with the speed: a joint with this friction has no rest set.
/// Source: the paper, section 3.1 (k constant, or growing with the pressure).
class ViscousLaw {
 public:
  /// @param constant  k0, Pa s/m, [0, infinity)
  /// @param pressure_slope  k1, s/m, [0, infinity)
  /// @throws Error if an argument is out of range.
  explicit ViscousLaw(double constant, double pressure_slope = 0);

  /// k0, Pa s/m
  double constant() const { return constant_; }
  /// k1, s/m
  double pressure_slope() const { return pressure_slope_; }

  /// Friction stress (k0 + k1 p) v, Pa.
  /// @param pressure  p, Pa, >= 0
  /// @param speed     v, m/s, >= 0
  double stress_at(double pressure, double speed) const {
    return (constant_ + pressure_slope_ * pressure) * speed;
  }

  friend bool operator==(const ViscousLaw&, const ViscousLaw&) = default;

 private:
  double constant_;
  double pressure_slope_;
};

/// The friction of a joint.
using FrictionModel = std::variant<FrictionLaw, ViscousLaw, FrictionStress>;

}  // namespace contact
