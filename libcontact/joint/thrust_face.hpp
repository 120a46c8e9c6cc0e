// SPDX-License-Identifier: MIT
#pragma once

#include "libcontact/pair/friction_law.hpp"

namespace contact {

/// A flat ring between two collars that carries the force along an axis, as the
/// washers of a door's hinge do: evenly pressed, with the friction moment
///
///     f0 |F| r + A (2 pi/3) (ro^3 - ri^3),  r = (2/3) (ro^3 - ri^3)/(ro^2 -
///     ri^2)
///
/// Collars are rigid and square to the axis; a tilt, or wear, which takes r to
/// (ri + ro)/2, is not known to it. Pressed from either side.
class ThrustFace {
 public:
  /// @param inner_radius  ri, m, [0, ro)
  /// @param outer_radius  ro, m, above 0
  /// @throws Error if an argument is out of range.
  ThrustFace(double inner_radius, double outer_radius, FrictionLaw friction);

  double inner_radius() const { return inner_radius_; }
  double outer_radius() const { return outer_radius_; }
  const FrictionLaw& friction() const { return friction_; }

  /// r, m: what others call friction arm.
  double arm() const { return arm_; }
  /// The moment that resists turning, N m; 0 without a force, when nothing
  /// touches. To 1e-13 (joint/thrust_face_test.cpp).
  /// @param force  F along the axis, N, of any sign
  double moment(double force) const noexcept;

  friend bool operator==(const ThrustFace& a, const ThrustFace& b) {
    return a.inner_radius_ == b.inner_radius_ &&
           a.outer_radius_ == b.outer_radius_ &&
           a.friction_.coefficient() == b.friction_.coefficient() &&
           a.friction_.adhesion() == b.friction_.adhesion();
  }

 private:
  double inner_radius_, outer_radius_;
  FrictionLaw friction_;
  double arm_;
  double adhesion_moment_;
};

}  // namespace contact
