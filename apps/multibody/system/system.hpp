// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

/// Carrier with hinged bodies (libcontact/docs/reference/multibody.md): bodies
/// and hinges, validated once. A body hangs on the carrier or on another body,
/// its parent.
///
/// Frames. Carrier axes: fixed to the carrier, origin at its centre of mass.
/// Body axes: fixed to the body, origin at its centre of mass, chosen by the
/// user. Parent axes: axes of the parent, the carrier or another body. Link
/// axes: the axes in which the body's equations are shortest; System finds
/// them, Link::axes converts to body axes. Hinge axes: z along the axis of an
/// axis node.
namespace multibody {

/// How a body hangs on its parent; system/hinges has a type for each.
enum class HingeKind {
  ball,  ///< ball joint: three relative turns
  axis,  ///< axis node: one turn about the common axis of its joints
  none,  ///< a body of its own
};

/// Numbers of a kind of hinge.
struct HingeTraits {
  int state_size;
  /// Index of a quaternion of length 1 in the state; -1: none.
  int quaternion;
  /// Whether it turns only about z of the link axes, by an angle that is the
  /// first number of its state; its rate is the second.
  bool is_axis;
  /// Link axis from the centre of mass to the hinge.
  int arm_axis;
};

/// The body that carries the others.
struct Carrier {
  double mass = 0;  ///< kg, > 0
  /// About the centre of mass, carrier axes, kg m^2.
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  /// Fixed in inertial space: hinges on it are hinges to the ground. Mass and
  /// inertia have no effect, and any point may be its centre of mass.
  bool fixed = false;
  bool flows = false;  ///< its mass changes: ForceModel::add_masses()
};

/// A body and its hinge, as the user describes them.
struct Body {
  HingeKind kind = HingeKind::ball;
  double mass;              ///< kg, > 0
  Eigen::Matrix3d inertia;  ///< about the centre of mass, body axes, kg m^2
  /// Centre of the hinge from the body's centre of mass, body axes, m (r_i).
  Eigen::Vector3d hinge_from_com = Eigen::Vector3d::Zero();
  /// The same point from the parent's centre of mass, parent axes, m (r_i0).
  Eigen::Vector3d hinge_from_carrier_com = Eigen::Vector3d::Zero();
  /// axis only: hinge axes to body axes (B_i).
  Eigen::Matrix3d hinge_to_body = Eigen::Matrix3d::Identity();
  /// axis only: hinge axes to parent axes at angle zero (B_i0 at zero).
  Eigen::Matrix3d hinge_to_carrier_zero = Eigen::Matrix3d::Identity();
  /// Index of the parent body, before or after this body; -1: the carrier.
  int parent = -1;
  bool flows = false;  ///< as Carrier::flows
};

/// A body in its own axes of calculation.
///
/// Ball: z along r, x and y so that N_i of (1.3) is diagonal; the hinge
/// is at (0, 0, arm). Axis: z along the axis, the origin of moments moved
/// along the axis to the foot of the perpendicular from the centre of mass,
/// which is at (arm, 0, 0). None: the body axes.
struct Link {
  HingeKind kind;
  double mass;
  double arm;               ///< distance of the centre of mass, m, >= 0
  Eigen::Matrix3d inertia;  ///< about the centre of mass, link axes
  Eigen::Vector3d hinge;    ///< hinge's centre (axis: foot), parent axes, m
  Eigen::Matrix3d axes;     ///< link axes to body axes
  /// axis only: link axes to parent axes at angle zero.
  Eigen::Matrix3d axes_to_carrier_zero;
  /// axis only: link axes to hinge axes (a turn about z).
  Eigen::Matrix3d axes_to_hinge;
  /// axis only: the hinge's centre is at (arm, 0, pole_offset).
  double pole_offset;
  int parent;  ///< as Body::parent
};

/// Carrier and bodies, checked and converted to link axes.
class System {
 public:
  /// @throws contact::Error naming body, quantity and allowed values: masses
  ///   finite and > 0; inertias finite, symmetric, with no negative principal
  ///   moment (the carrier's all > 0); rotations orthogonal to 1e-6 and
  ///   right-handed (then made exact); an axis body with inertia about its
  ///   axis; a ball body with inertia or an arm, in a deeper tree with inertia
  ///   about its arm; existing parents, without circles, none for a body
  ///   without a hinge.
  System(const Carrier& carrier, const std::vector<Body>& bodies);

  const Carrier& carrier() const { return carrier_; }
  const std::vector<Link>& links() const { return links_; }
  int size() const { return static_cast<int>(links_.size()); }
  /// All hang on the carrier and keep their masses, the paper's case: else it
  /// is a deeper tree, or solved as one.
  bool is_star() const { return is_star_; }
  /// Bodies in an order with children after parents; for a star 0, 1, ...
  const std::vector<int>& order() const { return order_; }

 private:
  Carrier carrier_;
  std::vector<Link> links_;
  std::vector<int> order_;
  bool is_star_ = true;
};

/// `matrix` made exactly orthogonal, if it is a rotation to 1e-6.
/// @throws contact::Error naming `place` otherwise
Eigen::Matrix3d checked_rotation(const Eigen::Matrix3d& matrix,
                                 const std::string& place);

}  // namespace multibody
