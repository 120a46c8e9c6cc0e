// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "libcontact/joint/contact.hpp"
#include "libcontact/joint/spec.hpp"

/// Joints that friction holds: docs/explanation/presliding.md.
namespace contact {

/// Stiffness of a contact that sticks all over against a turn of ball or pin,
/// and its decrease by partial slip up to the onset of sliding,
///
///     M/M_s = 1 - (1 - x/b)^b,  x = w K_load/M_s in [0, b]
///
/// for a turn w about an axis across the load, which stays as it is.
struct StuckJoint {
  /// K_load, N m/rad: the load stays. What a hinge in a mechanism has.
  double load_stiffness;
  /// K_held, N m/rad: the centre stays. NaN of a pin in an infinite hole.
  double held_stiffness;
  /// K_spin, N m/rad: a ball's turn about its load; NaN of pins.
  double spin_stiffness;
  /// M_s, N m: friction of slow sliding across the load; NaN unless dry.
  double friction_moment;
  /// b, from the stiffnesses and R rho^2/D; to 0.2 of pins that slip bit by
  /// bit, taken over for balls. A contact narrower than the friction angle
  /// rolls, b = 1, whatever this says.
  double shape;

  /// i of Dahl's model, (b - 1)/b.
  double dahl_exponent() const { return (shape - 1) / shape; }
  /// The turn at which the joint slides, b M_s/K_load, rad.
  double breakaway_angle() const {
    return shape * friction_moment / load_stiffness;
  }
  /// sigma0 of plain LuGre, N m/rad, that turns as far at M_s/2.
  double lugre_stiffness() const;
};

/// The rotation is measured between the outer body's far end and the mean over
/// the volume of a solid inner body; rims, tilt and adhesion's share are left
/// out.
///
/// Accuracy of the stiffnesses (joint/stuck_joint_test.cpp): 5e-4 of a
/// reference, of joints of data/joints at 300 N to 263 kN.
/// Cost: 1 to 30 ms, however thin the layers.
/// @param joint         what the contact was made from
/// @param normal_force  R_n, N, > 0
/// @param half_angle    theta0, [0.01, 3.1] rad
/// @return NaN for half-angles outside, with interference and for layers below
///         1e-3 radii
StuckJoint stuck_joint(const JointSpec& joint, const JointContact& contact,
                       double normal_force, double half_angle);

/// Why there is no stiffness: interference, thin layers, half-angles; "" where
/// there is one, and for NaN.
std::string stuck_refusal(const JointSpec& joint, double half_angle);

/// Notes, one sentence each: why there is no stiffness; if the shaft's
/// attachment determines it as much as the contact (homogeneous bodies above 43
/// deg), and on neglected rims and loads on the back; JointSpec::own_notes()
/// has the note on a relief.
std::vector<std::string> stuck_notes(const JointSpec& joint, double half_angle);

}  // namespace contact
