// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// How the inner body of a conforming contact is loaded, and how far it gives
/// way.
namespace contact {

/// Point at which the force that presses the inner body (ball, pin) into the
/// outer one acts. The half-angle depends on it (docs/explanation/walls.md).
class InnerLoading {
 public:
  /// A force at the centre, or weight and inertia spread over the body: a pin
  /// or a ball in one piece with its thick stem or fork. Both give exactly
  /// the same contact.
  static InnerLoading centre();

  /// A uniform normal pressure on a cap (ball) or an arc (pin) about the pole
  /// opposite the contact: a roller or a loose ball pressed from behind.
  ///
  /// @param patch_half_angle  psi, rad, [0, pi/2]; 0 is a concentrated force
  /// @throws Error if out of range.
  static InnerLoading back(double patch_half_angle);

  bool is_back() const { return back_; }
  /// psi, rad; 0 for centre().
  double patch_half_angle() const { return patch_half_angle_; }

  friend bool operator==(const InnerLoading&, const InnerLoading&) = default;

 private:
  InnerLoading(bool back, double patch_half_angle)
      : back_(back), patch_half_angle_(patch_half_angle) {}

  bool back_;
  double patch_half_angle_;
};

/// "centre", or "back:20" with psi in degrees, to six digits.
std::string to_string(const InnerLoading& loading);

/// How far the inner body has gone into the outer one.
struct ContactApproach {
  /// delta/eps, counted from first touch of the unloaded bodies: the centres
  /// are eps + delta apart. Of the inner body's mean over its volume, or of its
  /// rigid core; relative to the support of the outer body.
  double approach;
  /// Tangent stiffness at this load: dR_n/d delta in units of rho E (ball),
  /// dP/d delta in units of E (pin).
  double stiffness;
};

}  // namespace contact
