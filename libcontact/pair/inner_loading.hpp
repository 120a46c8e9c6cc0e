#pragma once

#include <string>

#include "libcontact/base/error.hpp"

/// What the exact solutions of conforming contact share: how the inner body
/// is loaded, and the results of both directions.
namespace contact {

/// Where the force that presses the inner body (ball, pin) into the outer one
/// acts on it. The half-angle depends on it (docs/conforming.md).
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

/// A half-angle from an exact solution.
struct ExactHalfAngle {
  /// theta0, rad. NaN if out_of_range; the largest angle the solution
  /// reaches if not_converged.
  double half_angle;
  Status status;
  /// Width of the last bracket about the root, rad.
  double bracket;
  /// Solutions of the contact problem that it took.
  int evaluations;
};

/// How far the inner body has gone into the outer one.
struct ContactApproach {
  /// delta/eps, counted from first touch of the unloaded bodies: the centres
  /// are eps + delta apart. Of the inner body's mean over its volume, or of
  /// its rigid core; relative to what holds the outer body.
  double approach;
  /// Force over approach, exact at this load: dR_n/d delta in units of rho E
  /// (ball), dP/d delta in units of E (pin).
  double stiffness;
};

/// A load parameter from an exact solution.
struct ExactLoad {
  /// lambda (pin) or mu (ball); NaN if out_of_range.
  double load_parameter;
  Status status;
  /// Estimate of the truncation error of 1/load_parameter: its change from
  /// four unknowns fewer, an upper bound in all measured cases.
  double reciprocal_error;
};

}  // namespace contact
