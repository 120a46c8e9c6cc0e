// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "libcontact/joint/spec.hpp"

namespace contact {

/// A force law at one penetration.
struct ForceState {
  double force;        ///< F, N
  double slope;        ///< dF/d delta, N/m
  double energy;       ///< W, the strain energy, J; F = dW/d delta
  double half_angle;   ///< theta0, rad
  double force_ratio;  ///< S, sum of the pressures over F; 1 without contact
  double half_angle_slope;  ///< d theta0/d delta, rad/m
};

/// The force law of a joint with clearance, exact for any elastic pair and any
/// walls: what presses the ball or pin back as it has gone the penetration
/// delta = |e| - eps into its seat or hole, e the vector from the centre of the
/// seat to the centre of the ball or pin. Theory: docs/how-to/play.md.
///
/// The constructor solves the contact at 64 to 256 half-angles, which takes 10
/// ms (ball) to 0.1 s (pin), with thin layers 0.5 s: make one law per joint. It
/// then is a piecewise polynomial, whose force is the derivative of its energy
/// to rounding; a force takes 20 ns. Copies share it, any number of threads
/// may, and functions do not throw. Below first touch the force is 0, above
/// largest_penetration() NaN. Below smallest_penetration(), theta0 = 0.17 deg,
/// the force is the power of delta that continues force and energy.
///
/// Accuracy (play/force_law_test.cpp): all within 3e-13 of the solver, and
/// within 1e-11 (ball) and 5e-11 (pin) of independent solutions. Of layers
/// thinner than 0.025 radii 3e-10: their edge is too sharp for the table.
class ForceLaw {
 public:
  /// @throws Error for a joint that is loaded through the back, and for a pin
  ///   in an infinite hole, which gives way without end.
  explicit ForceLaw(const JointSpec& joint);
  ~ForceLaw();
  /// The sentence of that Error; "" for a joint that has a law.
  /// @param asker  what requires a law; "": the joint with play
  static std::string refusal(const JointSpec& joint, std::string asker = {});

  /// @param penetration  delta, m; below 0 there is no contact
  ForceState at(double penetration) const noexcept;
  double force(double penetration) const noexcept;
  double slope(double penetration) const noexcept;
  double energy(double penetration) const noexcept;
  double half_angle(double penetration) const noexcept;
  double force_ratio(double penetration) const noexcept;

  /// Inverses, within 1e-12: delta of a force or an energy, [0, that at
  /// largest_penetration()]; NaN outside.
  double penetration_of_force(double force) const noexcept;
  double penetration_of_energy(double energy) const noexcept;

  /// About 80 deg of half-angle, or 0.1 % below the limit half-angle if that is
  /// less.
  double largest_penetration() const noexcept;
  double smallest_penetration() const noexcept;

  const JointGeometry& geometry() const noexcept { return geometry_; }

 private:
  struct Cell;
  struct Cells;
  template <class Quantity>
  double inverse(double value, const Quantity& quantity) const noexcept;

  JointGeometry geometry_;
  std::shared_ptr<const Cells> cells_;
};

}  // namespace contact
