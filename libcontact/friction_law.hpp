#pragma once

/// Dry friction whose coefficient depends on the contact pressure.
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

 private:
  double coefficient_;
  double adhesion_;
};

}  // namespace contact
